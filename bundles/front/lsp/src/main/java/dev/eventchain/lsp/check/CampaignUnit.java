package dev.eventchain.lsp.check;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.pipeline.campaign.CampaignFiles;
import dev.eventchain.project.ProjectFolder;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/** The campaign files of a project, whose findings no suppression of the project is about. */
record CampaignUnit(Path folder) implements CheckUnit {

  @Override
  public Path subject() {
    return new ProjectFolder(folder).configurationFile();
  }

  @Override
  public Optional<Path> project() {
    return Optional.of(folder);
  }

  @Override
  public List<Diagnostic> check() {
    return CampaignFiles.problems(folder);
  }
}
