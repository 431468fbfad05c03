package dev.eventchain.pipeline;

import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.agents.AgentResult;
import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;

/** What the stages that ask a language model have in common. */
final class AgentReport {

  private AgentReport() {}

  /** Adds what decides an answer besides files: settings, and how answers are had. */
  static void fingerprint(RunContext run, Stage stage, Fingerprint fingerprint) {
    Configuration configuration = run.project().configuration();
    fingerprint
        .addSetting("name", configuration.name())
        .addSetting("title", configuration.title())
        .addSetting("frequency", configuration.frequency())
        .add(configuration.model(stage))
        .add(configuration.repairs())
        .add(run.options().llm().orElse(configuration.llm()))
        .addMeans(filesBelow(run.project().recordings().resolve(stage.id())));
  }

  /** The model that answered and where its answers came from. */
  static ObjectNode of(RunContext run, Stage stage, List<AgentResult> results) {
    ObjectNode report = JsonNodeFactory.instance.objectNode();
    report.put("model", run.project().configuration().model(stage));
    Set<String> provenance = new TreeSet<>();
    results.stream()
        .flatMap(result -> result.attempts().stream())
        .forEach(attempt -> provenance.add(attempt.response().provenance()));
    report.put("provenance", String.join(", ", provenance));
    return report;
  }

  /** What was found in an answer, in the files that it becomes. */
  static List<Diagnostic> placed(RunContext run, AgentResult result) {
    return result.diagnostics().stream().map(finding -> placed(run, finding)).toList();
  }

  /** A finding in an answer where it is in the file that the answer becomes. */
  static Diagnostic placed(RunContext run, Diagnostic finding) {
    SourceLocation place = finding.location();
    return becomesFile(place.file())
        ? finding.withLocation(place.inFile(run.file(place.file())))
        : finding;
  }

  /** What an answer is about may be wrong elsewhere, such as in a message definition. */
  private static boolean becomesFile(String name) {
    return name.equals(DesignStage.FILE)
        || name.equals(Constraints.GENERATED)
        || name.startsWith(ImplementStage.FOLDER + "/");
  }

  /** How many answers had to be corrected, in words; empty if none. */
  static String repairs(List<AgentResult> results) {
    int repairs = results.stream().mapToInt(result -> result.attempts().size() - 1).sum();
    return repairs == 0 ? "" : ", " + Coverage.counted(repairs, "answer") + " corrected";
  }

  private static List<Path> filesBelow(Path folder) {
    if (!Files.isDirectory(folder)) {
      return List.of();
    }
    try (Stream<Path> files = Files.walk(folder)) {
      return files.filter(Files::isRegularFile).sorted().toList();
    } catch (IOException e) {
      throw Project.unreadable(folder, e);
    }
  }
}
