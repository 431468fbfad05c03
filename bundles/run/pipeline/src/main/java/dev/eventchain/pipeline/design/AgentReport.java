package dev.eventchain.pipeline.design;

import dev.eventchain.agents.AgentResult;
import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.FileRules;
import dev.eventchain.diagnostics.Severity;
import dev.eventchain.llm.Spending;
import dev.eventchain.pipeline.project.Configuration;
import dev.eventchain.pipeline.results.Answers;
import dev.eventchain.pipeline.run.Stage;
import dev.eventchain.pipeline.stage.Fingerprint;
import dev.eventchain.pipeline.stage.RunContext;
import java.io.IOException;
import java.math.BigDecimal;
import java.math.RoundingMode;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;

/** Common report data of the stages that ask a language model. */
final class AgentReport {

  private AgentReport() {}

  /** Adds the inputs of answers besides files: settings and the source of answers. */
  static void fingerprint(RunContext run, Stage stage, Fingerprint fingerprint) {
    Configuration configuration = run.project().configuration();
    fingerprint
        .addSetting("name", configuration.name())
        .addSetting("title", configuration.title())
        .addSetting("frequency", configuration.frequency())
        .add(configuration.models(stage.id()))
        .add(configuration.repairs())
        .add(run.options().answers().source().orElse(configuration.llm()))
        .addMeans(recordings(run, stage));
  }

  private static List<Path> recordings(RunContext run, Stage stage) {
    Path recordings = run.project().recordings();
    List<Path> files = new ArrayList<>(filesBelow(recordings.resolve(stage.id())));
    if (stage == Stage.IMPLEMENT) {
      files.addAll(filesBelow(recordings.resolve("test")));
    }
    return files;
  }

  /** Returns the model that answered and the source of its answers. */
  static Answers of(RunContext run, Stage stage, List<AgentResult> results) {
    Set<String> provenance = new TreeSet<>();
    results.stream()
        .flatMap(result -> result.attempts().stream())
        .forEach(attempt -> provenance.add(attempt.response().provenance()));
    Set<String> returned = new TreeSet<>();
    results.forEach(result -> returned.addAll(returned(result)));
    return new Answers(
        String.join(", ", run.project().configuration().models(stage.id())),
        String.join(", ", provenance),
        List.copyOf(returned),
        run.models().conversation(stage),
        Optional.empty(),
        Optional.empty());
  }

  /** Returns the identifiers of the errors in answers that were sent back. */
  private static List<String> returned(AgentResult result) {
    return result.attempts().subList(0, result.attempts().size() - 1).stream()
        .flatMap(attempt -> attempt.findings().stream())
        .filter(finding -> finding.severity() == Severity.ERROR)
        .map(Diagnostic::id)
        .toList();
  }

  /** Returns the findings in an answer, located in the files written from it. */
  static List<Diagnostic> placed(RunContext run, AgentResult result) {
    return result.diagnostics().stream().map(run.models()::placed).toList();
  }

  /**
   * Returns the number of corrected answers and the run's spending; empty if there is nothing to
   * report.
   */
  static String effort(RunContext run, List<AgentResult> results) {
    int repairs = results.stream().mapToInt(result -> result.attempts().size() - 1).sum();
    String corrected =
        repairs == 0 ? "" : ", " + Coverage.counted(repairs, "answer") + " corrected";
    return corrected + spent(run.models().spending().lines());
  }

  private static String spent(List<Spending.Line> lines) {
    if (lines.isEmpty()) {
      return "";
    }
    long tokens = lines.stream().mapToLong(each -> each.inputTokens() + each.outputTokens()).sum();
    BigDecimal cost =
        lines.stream()
            .flatMap(each -> each.cost().stream())
            .reduce(BigDecimal.ZERO, BigDecimal::add);
    String price =
        lines.stream().allMatch(each -> each.cost().isPresent())
            ? ", cost "
                + cost.setScale(4, RoundingMode.HALF_UP).stripTrailingZeros().toPlainString()
            : "";
    return String.format(Locale.ROOT, "; %,d tokens%s so far", tokens, price);
  }

  private static List<Path> filesBelow(Path folder) {
    if (!Files.isDirectory(folder)) {
      return List.of();
    }
    try (Stream<Path> files = Files.walk(folder)) {
      return files.filter(Files::isRegularFile).sorted().toList();
    } catch (IOException e) {
      throw FileRules.refusal("The folder", folder, e);
    }
  }
}
