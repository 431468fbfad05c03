package dev.eventchain.cli;

import dev.eventchain.cli.console.Console;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.NearestName;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.diagnostics.RulePage;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.pipeline.ExitCode;
import dev.eventchain.pipeline.StandardRule;
import java.io.PrintWriter;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Parameters;

/** {@code explain}: explains a finding and how to fix it. */
@Command(
    name = "explain",
    mixinStandardHelpOptions = true,
    description = "Explain a finding by its id, or list all ids.")
final class ExplainCommand implements Callable<Integer> {
  private static final Rule UNKNOWN = Rule.error("explain.unknown");

  @Parameters(
      arity = "0..1",
      paramLabel = "ID",
      description =
          "The id in brackets after a finding, such as ocl.violated, or a standard "
              + "constraint, such as SoftwareNode::FrequencyIsPositive. Default: all are "
              + "listed.")
  private String id;

  private final Console console;

  ExplainCommand(Console console) {
    this.console = console;
  }

  @Override
  public Integer call() {
    PrintWriter out = console.out();
    out.print(id == null ? list() : page());
    out.flush();
    return ExitCode.FINE;
  }

  private static String list() {
    List<RulePage> pages = RulePage.all();
    int width = pages.stream().mapToInt(page -> page.id().length()).max().orElse(1);
    StringBuilder text = new StringBuilder();
    String bundle = "";
    for (RulePage page : pages) {
      if (!page.bundle().equals(bundle)) {
        bundle = page.bundle();
        text.append(text.isEmpty() ? "" : "\n").append(bundle).append('\n');
      }
      String line = String.format(Locale.ROOT, "  %-" + width + "s  ", page.id());
      text.append(line).append(page.firstSentence()).append('\n');
    }
    text.append("\nstandard constraints\n");
    StandardRule.names().forEach(name -> text.append("  ").append(name).append('\n'));
    return text.toString();
  }

  /** Returns the page; SARIF names a constraint's findings {@code ocl.violated/Class::Name}. */
  private String page() {
    int slash = id.indexOf('/');
    String rule = id.substring(slash + 1);
    return StandardRule.page(rule)
        .or(() -> RulePage.of(slash < 0 ? id : id.substring(0, slash)).map(RulePage::text))
        .orElseThrow(this::unknown);
  }

  private DiagnosticException unknown() {
    List<String> known = new ArrayList<>(StandardRule.names());
    RulePage.all().forEach(page -> known.add(page.id()));
    return new DiagnosticException(
        DiagnosticException.Reason.INPUT,
        Diagnostic.of(UNKNOWN, "There is no finding '" + id + "'.", SourceLocation.NONE)
            .withHint(
                NearestName.of(id, known)
                    .map(nearest -> "Did you mean `" + nearest + "`?")
                    .orElse("'eventchain explain' lists them all.")));
  }
}
