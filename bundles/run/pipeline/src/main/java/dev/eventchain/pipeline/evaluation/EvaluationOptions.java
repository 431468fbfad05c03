package dev.eventchain.pipeline.evaluation;

import dev.eventchain.diagnostics.Suppressions;
import dev.eventchain.pipeline.project.Configuration;
import dev.eventchain.pipeline.project.Project;
import java.nio.file.Path;
import java.time.Duration;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/**
 * The language models that an evaluation compares, and its settings.
 *
 * @param output the folder of the project's results, below which the evaluation has one of its own
 * @param models the models; empty for those of the project's configuration
 * @param runs the number of runs per model
 * @param parallel the number of runs in parallel
 * @param llm the source of answers; empty for that of the project's configuration
 * @param suppressions the findings that do not count
 * @param timeLimit the processor time that a constraint may take on the whole model
 */
public record EvaluationOptions(
    Path output,
    List<String> models,
    int runs,
    int parallel,
    Optional<String> llm,
    Suppressions suppressions,
    Duration timeLimit) {

  private static final int MOST_RUNS = 99;
  private static final int MOST_PARALLEL = 64;
  private static final String COMMAND = "command:";

  /**
   * Checks the values that do not depend on the project.
   *
   * @throws IllegalArgumentException with a message about the error
   */
  public EvaluationOptions {
    models = models.stream().map(String::strip).toList();
    require(
        runs >= 1 && runs <= MOST_RUNS,
        "the number of runs must be 1 to " + MOST_RUNS + ": --runs 5");
    require(
        parallel >= 1 && parallel <= MOST_PARALLEL,
        "1 to " + MOST_PARALLEL + " runs can be done at once: --parallel 2");
    require(models.stream().noneMatch(String::isEmpty), "a model has no name: --models a,b");
    require(!models.contains(Configuration.DIRECT), "'direct' is not a language model");
    Set<String> seen = new LinkedHashSet<>();
    models.forEach(model -> require(seen.add(model), "'" + model + "' is named twice"));
  }

  private static void require(boolean holds, String otherwise) {
    if (!holds) {
      throw new IllegalArgumentException(otherwise);
    }
  }

  /**
   * Returns these options with the models that a project or the source of answers names.
   *
   * @throws IllegalArgumentException with a message if they do not fit the project
   */
  public EvaluationOptions in(Project project) {
    String source = source(project);
    Optional<AnswerSets> sets = AnswerSets.of(source);
    if (sets.isPresent()) {
      return ofSessions(sets.get());
    }
    boolean isModel =
        project.configuration().services().names().contains(source.replaceFirst("(?s)/.*", ""))
            && source.contains("/");
    require(
        !isModel || models.isEmpty() || llm.isEmpty(),
        "--llm " + source + " names a model, and so does --models");
    List<String> named =
        !models.isEmpty()
            ? models
            : isModel ? List.of(source) : project.configuration().languageModels();
    require(!named.isEmpty(), "no language model is configured: --models a,b");
    Optional<String> answers = isModel ? Optional.of("live") : llm;
    return new EvaluationOptions(output, named, runs, parallel, answers, suppressions, timeLimit);
  }

  /** Returns the options for recorded sessions: each is a run, whatever number was given. */
  private EvaluationOptions ofSessions(AnswerSets sets) {
    require(models.size() <= 1, "the sessions of a folder are those of one model");
    List<String> named = models.isEmpty() ? List.of(sets.name()) : models;
    return new EvaluationOptions(
        output, named, sets.folders().size(), parallel, llm, suppressions, timeLimit);
  }

  /** Returns the source of answers. */
  String source(Project project) {
    return llm.orElse(project.configuration().llm());
  }

  /** Returns the kind of source for people: without a command's arguments and without folders. */
  String kindOfSource(Project project) {
    return source(project).replaceFirst("(?s):.*", "");
  }

  /** Returns whether answers are taken from the project's recordings. */
  boolean takesRecordings(Project project) {
    String source = source(project);
    return !source.equals("live") && !source.startsWith(COMMAND) && AnswerSets.of(source).isEmpty();
  }
}
