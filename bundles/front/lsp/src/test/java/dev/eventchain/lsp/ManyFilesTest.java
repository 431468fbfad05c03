package dev.eventchain.lsp;

import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.constraints.editing.RuleLanguageService;
import dev.eventchain.editing.Analysis;
import dev.eventchain.editing.TextPosition;
import dev.eventchain.lsp.check.Checks;
import dev.eventchain.lsp.check.Findings;
import dev.eventchain.lsp.check.RulePageFiles;
import dev.eventchain.lsp.check.Settings;
import dev.eventchain.lsp.language.EditorWorkspace;
import dev.eventchain.lsp.text.OpenText;
import dev.eventchain.lsp.text.OpenTexts;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import org.eclipse.lsp4j.Position;
import org.eclipse.lsp4j.Range;
import org.eclipse.lsp4j.TextDocumentContentChangeEvent;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** An answer about one document costs the same however many others there are. */
class ManyFilesTest {

  private static final int FEW = 15;
  private static final int MANY = 1_500;
  private static final int QUESTIONS = 40;

  /** Processor time of an answer about one of many documents beyond that about one of few. */
  private static final double MOST_MORE = 5;

  private static final ThreadMXBean CLOCK = ManagementFactory.getThreadMXBean();

  @TempDir private Path folder;

  @Test
  void anAnswerCostsTheSameAmongManyDocuments() throws Exception {
    Path small = Files.createDirectory(folder.resolve("small"));
    Path large = Files.createDirectory(folder.resolve("large"));
    milliseconds(small, FEW);
    double few = milliseconds(small, FEW);
    double many = milliseconds(large, MANY);
    assertTrue(many < few + MOST_MORE, few + " ms among few, " + many + " ms among many");
  }

  /** Returns the median of the processor time of hovers, each after a letter has been typed. */
  private static double milliseconds(Path in, int count) throws Exception {
    for (int i = 0; i < count; i++) {
      write(in, i);
    }
    Path file = in.resolve("d0/rules0.ocl");
    OpenTexts texts = new OpenTexts();
    try (RulePageFiles pages = new RulePageFiles()) {
      Checks checks = new Checks(texts, new Findings(texts, pages, each -> {}), each -> {});
      checks.open(List.of(in), Settings.USUAL);
      while (checks.files().all().size() < count) {
        Thread.sleep(5);
      }
      checks.close();
      RuleLanguageService service = new RuleLanguageService(new EditorWorkspace(texts, checks));
      texts.open(new OpenText(file.toUri().toString(), file, 1, Files.readString(file)));
      hover(service, file);
      double[] times = new double[QUESTIONS];
      Position end = new Position(0, 0);
      for (int i = 0; i < QUESTIONS; i++) {
        texts.change(
            file, i, List.of(new TextDocumentContentChangeEvent(new Range(end, end), " ")));
        long start = CLOCK.getCurrentThreadCpuTime();
        hover(service, file);
        times[i] = (CLOCK.getCurrentThreadCpuTime() - start) / 1e6;
      }
      Arrays.sort(times);
      return times[QUESTIONS / 2];
    }
  }

  private static void write(Path in, int number) throws IOException {
    Path file = in.resolve(String.format(Locale.ROOT, "d%d/rules%d.ocl", number / 100, number));
    Files.createDirectories(file.getParent());
    if (!Files.exists(file)) {
      Files.writeString(
          file,
          String.format(
              Locale.ROOT,
              """
          import 'rules%d.ocl'
          package eventchain
          context EventChain
          def: total%d : Integer = software->size()
          inv Small: self.total%d < 100 and name <> ''
          endpackage
          """,
              number / 10 * 10,
              number,
              number));
    }
  }

  private static void hover(RuleLanguageService service, Path file) {
    Analysis analysis = service.analysis(file).orElseThrow();
    int line = 4;
    assertTrue(analysis.hover(new TextPosition(line, "inv Small: self.t".length())).isPresent());
  }
}
