package dev.eventchain.pipeline.design;

import dev.eventchain.agents.Diagnosis;
import dev.eventchain.output.OutputFolder;
import dev.eventchain.pipeline.results.AnsweredPrompt;
import dev.eventchain.pipeline.results.ResultJson;
import dev.eventchain.pipeline.run.Stage;
import dev.eventchain.pipeline.stage.Correction;
import dev.eventchain.pipeline.stage.Fingerprint;
import dev.eventchain.pipeline.stage.RunContext;
import java.io.IOException;
import java.nio.file.Files;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/**
 * The diagnoses that led to the present design and components. They outlive the run, since a person
 * who answers prompts needs several runs for one way to the verdict, and each of them must know
 * what was tried before.
 *
 * @param key the fingerprint of what components are written from; with other inputs, nothing was
 *     tried yet
 * @param diagnoses the diagnoses, oldest first
 * @param kept the components whose description a corrected design leaves as it is
 * @param conversation the prompts and answers from which the kept ones come
 */
record StandingDiagnoses(
    String key, List<Diagnosis> diagnoses, Set<String> kept, List<AnsweredPrompt> conversation) {
  private static final String FILE = ".stages/diagnoses.json";

  StandingDiagnoses {
    diagnoses = List.copyOf(diagnoses);
    kept = Set.copyOf(kept);
    conversation = List.copyOf(conversation);
  }

  /** Tells a run whose components are those of an earlier one what that one has found. */
  static void restore(RunContext run) {
    if (run.models().diagnoses().isEmpty()) {
      read(run).ifPresent(found -> run.models().diagnoses().addAll(found.diagnoses));
    }
  }

  /**
   * Continues an earlier run that waited for components of a corrected design: the others are kept.
   */
  static void resume(RunContext run) {
    if (run.models().diagnoses().isEmpty() && !run.options().stages().again()) {
      read(run)
          .filter(found -> !found.kept.isEmpty())
          .ifPresent(
              found -> {
                run.models().diagnoses().addAll(found.diagnoses);
                run.models().correct(Correction.keeping(found.kept));
                run.models().conversation(Stage.IMPLEMENT).addAll(found.conversation);
              });
    }
  }

  private static Optional<StandingDiagnoses> read(RunContext run) {
    try {
      byte[] json = Files.readAllBytes(run.file(FILE));
      return ResultJson.ifValid(json, StandingDiagnoses.class)
          .filter(found -> found.key.equals(key(run)));
    } catch (IOException e) {
      return Optional.empty(); // Nothing was found yet.
    }
  }

  /** Stores what a run has found, before components are written from it. */
  static void store(RunContext run) {
    Set<String> kept = run.models().correction().kept();
    StandingDiagnoses standing =
        new StandingDiagnoses(
            key(run),
            run.models().diagnoses(),
            kept,
            kept.isEmpty() ? List.of() : run.models().conversation(Stage.IMPLEMENT));
    run.output().write(FILE, ResultJson.bytes(standing), OutputFolder.OnEdit.OVERWRITE);
  }

  private static String key(RunContext run) {
    Fingerprint inputs = new Fingerprint(run);
    new ImplementStage().fingerprint(run, inputs);
    return inputs.value();
  }
}
