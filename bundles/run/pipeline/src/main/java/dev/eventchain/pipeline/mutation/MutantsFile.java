package dev.eventchain.pipeline.mutation;

import dev.eventchain.documents.JsonLayout;
import dev.eventchain.pipeline.results.ResultJson;
import dev.eventchain.pipeline.stage.RunContext;
import dev.eventchain.project.ProjectLayout;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Optional;

/**
 * The content of {@code mutants.json}: results, from which an interrupted command continues.
 *
 * @param chain the chain's name
 * @param inputs a hash of everything that the results depend on
 * @param mutants all mutants of all components, in the order of the chain and of their places
 */
record MutantsFile(String chain, String inputs, List<MutantResult> mutants) {

  /** Copies the list. */
  MutantsFile {
    mutants = List.copyOf(mutants);
  }

  /**
   * Returns the results of an earlier command with the same inputs; none if there are none, or if
   * somebody has changed the file.
   */
  static List<MutantResult> recall(RunContext run, String inputs) {
    Optional<byte[]> bytes =
        run.output().isEdited(ProjectLayout.MUTANT_RESULTS)
            ? Optional.empty()
            : run.output().read(ProjectLayout.MUTANT_RESULTS);
    return bytes
        .flatMap(it -> ResultJson.ifValid(it, MutantsFile.class))
        .filter(file -> file.inputs().equals(inputs))
        .map(MutantsFile::proved)
        .orElse(List.of());
  }

  /** Returns the results without those of which nothing is known, so that they are tried again. */
  private List<MutantResult> proved() {
    return mutants.stream()
        .filter(each -> each.outcome() != MutantResult.Outcome.UNPROVED)
        .toList();
  }

  void write(RunContext run) {
    String json = JsonLayout.of(ResultJson.tree(this)) + "\n";
    run.writeResult(ProjectLayout.MUTANT_RESULTS, json.getBytes(StandardCharsets.UTF_8));
  }
}
