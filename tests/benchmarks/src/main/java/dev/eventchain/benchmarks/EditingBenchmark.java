package dev.eventchain.benchmarks;

import dev.eventchain.constraints.editing.RuleLanguageService;
import dev.eventchain.editing.Analysis;
import dev.eventchain.editing.LanguageService;
import dev.eventchain.editing.MemoryWorkspace;
import dev.eventchain.editing.TextLines;
import dev.eventchain.editing.TextPosition;
import dev.eventchain.m2t.editing.TemplateLanguageService;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Random;
import java.util.TreeMap;
import java.util.function.Consumer;
import org.eclipse.emf.ecore.EcorePackage;

/**
 * Times the answers to an editor while somebody types in files of 10,000 lines: a rule document,
 * and a module of 200 templates and 170 queries. Each answer is to a new version of the text.
 */
public final class EditingBenchmark {

  private static final int WARM_UP = 60;
  private static final int EDITS = 200;

  /** Processor time, so that other work on the machine does not count. */
  private static final ThreadMXBean CLOCK = ManagementFactory.getThreadMXBean();

  private final Random random = new Random(1);
  private final Map<String, double[]> times = new TreeMap<>();

  private EditingBenchmark() {}

  /**
   * Prints milliseconds of processor time: median, 95th percentile and greatest of 200.
   *
   * @param arguments nothing
   */
  public static void main(String[] arguments) {
    EditingBenchmark benchmark = new EditingBenchmark();
    MemoryWorkspace workspace = new MemoryWorkspace(List.of(EcorePackage.eINSTANCE));
    benchmark.run(
        "rules", workspace, new RuleLanguageService(workspace), Path.of("rules.ocl"), rules());
    benchmark.run(
        "templates",
        workspace,
        new TemplateLanguageService(workspace),
        Path.of("main.mtl"),
        templates());
    benchmark.times.forEach(EditingBenchmark::print);
  }

  private static void print(String name, double[] values) {
    Arrays.sort(values);
    System.out.printf(
        Locale.ROOT,
        "%-28s p50 %7.1f ms, p95 %7.1f ms, greatest %7.1f ms%n",
        name,
        values[values.length / 2],
        values[values.length * 95 / 100],
        values[values.length - 1]);
  }

  private static String rules() {
    StringBuilder text = new StringBuilder();
    for (int i = 0; i < 1_250; i++) {
      text.append("context EClass\n");
      if (i % 8 == 0) {
        text.append(
            String.format(
                Locale.ROOT, "  def: many%d : Boolean = self.eAllReferences->size() > %d\n", i, i));
      }
      text.append(
          String.format(
              Locale.ROOT,
              """
            inv Rule%1$d:
              let all : OrderedSet(EStructuralFeature) = self.eAllStructuralFeatures in
              all->forAll(f | f.name <> null and f.name.size() > %1$d
                implies f.eAnnotations->isEmpty())

            -- Rule %1$d ends here.
          """,
              i));
    }
    return text.toString();
  }

  private static String templates() {
    StringBuilder text = new StringBuilder("[module main('" + EcorePackage.eNS_URI + "')]\n");
    for (int i = 0; i < 170; i++) {
      text.append(
          String.format(
              Locale.ROOT,
              "[query public wide%1$d(c : EClass) : Boolean = c.eAttributes->size() > %1$d /]\n",
              i));
    }
    for (int i = 0; i < 200; i++) {
      text.append(String.format(Locale.ROOT, "[template public page%d(c : EClass)]\n", i));
      for (int j = 0; j < 6; j++) {
        text.append(
            String.format(
                Locale.ROOT,
                """
            # [c.name/]
            [for (f | c.eAllStructuralFeatures)]
            [if (f.name.size() > %2$d and c.wide%1$d())]
              [f.name.toUpperFirst()/] : [f.eType.name/]
            [else]
              [let owner : EClass = f.eContainingClass]
              [owner.name/]
              [/let]
            [/if]
            """,
                (i + j) % 170,
                j));
        text.append("[/for]\n");
      }
      text.append("[/template]\n");
    }
    return text.toString();
  }

  private void run(
      String name, MemoryWorkspace workspace, LanguageService service, Path file, String text) {
    String typed = name.equals("rules") ? "self.eAllStructuralFeatures." : "[f.eContainingClass.";
    String before = name.equals("rules") ? "all->forAll(" : "[f.eType.name/]";
    System.out.println(name + ": " + text.lines().count() + " lines");
    for (int i = -WARM_UP; i < EDITS; i++) {
      int at = text.indexOf(before, random.nextInt(text.length() * 9 / 10));
      String edited = text.substring(0, at) + typed + text.substring(at);
      workspace.put(file, edited);
      TextPosition position = new TextLines(edited).position(at + typed.length());
      time(i, name + " completion", service, file, each -> each.completions(position));
      time(i, name + " hover", service, file, each -> each.hover(position));
      time(i, name + " outline", service, file, Analysis::symbols);
      time(i, name + " tokens", service, file, Analysis::tokens);
    }
  }

  private void time(
      int round, String name, LanguageService service, Path file, Consumer<Analysis> question) {
    long start = CLOCK.getCurrentThreadCpuTime();
    question.accept(service.analysis(file).orElseThrow());
    if (round >= 0) {
      double milliseconds = (CLOCK.getCurrentThreadCpuTime() - start) / 1e6;
      times.computeIfAbsent(name, none -> new double[EDITS])[round] = milliseconds;
    }
  }
}
