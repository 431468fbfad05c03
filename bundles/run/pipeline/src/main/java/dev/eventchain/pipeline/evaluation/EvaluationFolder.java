package dev.eventchain.pipeline.evaluation;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.diagnostics.Sha256;
import dev.eventchain.documents.JsonLayout;
import dev.eventchain.output.OutputFolder;
import dev.eventchain.pipeline.project.Configuration;
import dev.eventchain.pipeline.project.Project;
import dev.eventchain.pipeline.results.ResultJson;
import dev.eventchain.pipeline.stage.Fingerprint;
import dev.eventchain.pipeline.stage.RunContext;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;

/**
 * The folder of an evaluation: a folder per run, with a file that exists once the run has ended and
 * names its inputs. Thread-safe.
 */
final class EvaluationFolder implements AutoCloseable {

  static final String NAME = "evaluation";
  static final String JSON = "evaluation.json";
  static final String PAGE = "evaluation.html";

  private static final String RESULT = "result.json";
  private static final Set<String> RESERVED = Set.of(JSON, PAGE);
  private static final int LONGEST_NAME = 60;
  private static final int HASH = 8;

  /** The content of the file of a run that has ended. */
  private record Finished(String inputs, EvaluatedRun run) {}

  private final Path base;
  private final OutputFolder output;

  private EvaluationFolder(Path base) {
    this.base = base;
    this.output = OutputFolder.open(base);
  }

  /**
   * Opens the folder below that of the project's results, and deletes the results of an earlier
   * evaluation.
   */
  static EvaluationFolder open(Path results) {
    EvaluationFolder folder = new EvaluationFolder(results.resolve(NAME));
    folder.output.write(RunContext.IGNORE, new byte[0], OutputFolder.OnEdit.OVERWRITE);
    RESERVED.forEach(folder.output::remove);
    return folder;
  }

  /** Returns the name of a run's folder: valid and unique for any model name. */
  static String nameOf(String model, int number) {
    String safe = model.replaceAll("[^A-Za-z0-9._-]", "_").replaceAll("^[.-]|[.-]$", "_");
    safe = safe.substring(0, Math.min(safe.length(), LONGEST_NAME));
    boolean same = safe.equals(model) && !RESERVED.contains(safe);
    String hash = Sha256.of(model).hex().substring(0, HASH);
    return String.format(Locale.ROOT, "%s/run-%02d", same ? safe : safe + "-" + hash, number);
  }

  Path path(String name) {
    return base.resolve(name);
  }

  /** Returns the result of a finished run, if it was made from the same inputs. */
  Optional<EvaluatedRun> finished(String run, String inputs) {
    return output
        .read(run + "/" + RESULT)
        .flatMap(bytes -> ResultJson.ifValid(bytes, Finished.class))
        .filter(finished -> finished.inputs().equals(inputs))
        .map(Finished::run);
  }

  /** Deletes the result of a run that begins. */
  void begin(String run) {
    output.remove(run + "/" + RESULT);
  }

  /** Saves the result of a run. */
  void finish(String run, String inputs, EvaluatedRun result) {
    JsonNode json = ResultJson.tree(new Finished(inputs, result));
    write(run + "/" + RESULT, JsonLayout.of(json) + "\n");
  }

  /** Writes a result; replaces any existing file. */
  void write(String name, String text) {
    byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
    output.write(name, bytes, OutputFolder.OnEdit.OVERWRITE);
  }

  /** Returns the fingerprint of all inputs of a run: files, settings and this program. */
  static String inputs(
      Project project,
      EvaluationOptions options,
      String model,
      int number,
      Optional<ReferenceChain> reference) {
    Configuration settings = project.configuration();
    Sha256 digest = new Sha256();
    for (Object part :
        List.of(
            Fingerprint.PROGRAM,
            model,
            number,
            options.source(project),
            options.timeLimit(),
            options.suppressions().inForce(),
            settings.name(),
            settings.title(),
            settings.frequency(),
            settings.repairs(),
            settings.template(),
            settings.packageFacts(),
            reference)) {
      add(digest, String.valueOf(part));
    }
    project.sources().forEach(file -> addFile(digest, project, file));
    if (options.takesRecordings(project)) {
      Project.existingBelow(project.recordings()).forEach(each -> addFile(digest, project, each));
    }
    AnswerSets.of(options.source(project)).ifPresent(sets -> addSessions(digest, sets));
    return digest.hex();
  }

  private static void addSessions(Sha256 digest, AnswerSets sets) {
    for (Path file : sets.files()) {
      add(digest, file.toString());
      add(digest, Fingerprint.contentOf(file));
    }
  }

  private static void addFile(Sha256 digest, Project project, Path file) {
    add(digest, project.folder().relativize(file).toString());
    add(digest, Fingerprint.contentOf(file));
  }

  private static void add(Sha256 digest, String text) {
    digest.add(text.length() + ":").add(text);
  }

  @Override
  public void close() {
    output.close();
  }
}
