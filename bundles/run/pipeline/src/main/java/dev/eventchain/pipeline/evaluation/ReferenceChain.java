package dev.eventchain.pipeline.evaluation;

import dev.eventchain.check.ChainModel;
import dev.eventchain.description.EventChainWriter;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.model.EventChainMetamodel;
import dev.eventchain.pipeline.project.Project;
import dev.eventchain.project.ProjectFolder;
import dev.eventchain.project.ProjectLayout;
import dev.eventchain.xmi.LoadedModel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * The chain for the components of a language model that has designed no chain, so that its code can
 * still be judged.
 *
 * @param name the name for people
 * @param description the text of its {@code chain.json}
 */
record ReferenceChain(String name, String description) {

  /**
   * Returns the edited chain, or else that of the latest run.
   *
   * @param output the folder of the project's results, if the default one has none
   * @throws dev.eventchain.diagnostics.DiagnosticException INPUT if it cannot be read
   */
  static Optional<ReferenceChain> of(Project project, Path output) {
    Optional<Path> edited = project.editedModel();
    if (edited.isPresent()) {
      LoadedModel loaded =
          EventChainMetamodel.store(project.folder()).loadAll(List.of(edited.get())).get(0);
      String description = EventChainWriter.write(ChainModel.chainOf(loaded, edited.get()));
      return Optional.of(new ReferenceChain(ProjectLayout.MODEL, description));
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
