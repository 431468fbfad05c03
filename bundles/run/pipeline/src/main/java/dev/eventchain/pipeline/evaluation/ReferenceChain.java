package dev.eventchain.pipeline.evaluation;

import dev.eventchain.check.ChainModel;
import dev.eventchain.description.EventChainWriter;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.model.EventChainMetamodel;
import dev.eventchain.pipeline.project.Project;
import dev.eventchain.project.ProjectFolder;
import dev.eventchain.xmi.LoadedModel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * The chain whose components a language model writes where it has designed none itself, so that its
 * code is judged nevertheless.
 *
 * @param name what people know it by
 * @param description the text of its {@code chain.json}
 */
record ReferenceChain(String name, String description) {

  /**
   * The chain that people edit, else that of the latest run.
   *
   * @param output the folder of the project's results, where the usual one has none
   * @throws dev.eventchain.diagnostics.DiagnosticException INPUT if there is one that cannot be
   *     read
   */
  static Optional<ReferenceChain> of(Project project, Path output) {
    Optional<Path> edited = project.editedModel();
    if (edited.isPresent()) {
      LoadedModel loaded =
          EventChainMetamodel.store(project.folder()).loadAll(List.of(edited.get())).get(0);
      String description = EventChainWriter.write(ChainModel.chainOf(loaded, edited.get()));
      return Optional.of(new ReferenceChain("model/chain.xmi", description));
    }
    return Stream.of(output, project.defaultOutput())
        .map(folder -> folder.resolve(ProjectFolder.DESCRIPTION))
        .filter(Files::isRegularFile)
        .findFirst()
        .map(
            file ->
                new ReferenceChain("chain.json of the latest run", SourceText.read(file).text()));
  }
}
