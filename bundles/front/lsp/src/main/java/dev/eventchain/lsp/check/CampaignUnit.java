package dev.eventchain.lsp.check;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.pipeline.campaign.CampaignFiles;
import java.nio.file.Path;
import java.util.List;

/** The campaign files of a project, whose findings no suppression of the project is about. */
record CampaignUnit(Path folder) implements CheckUnit.OfProject {

  @Override
  public List<Diagnostic> check() {
    return CampaignFiles.problems(folder);
  }
}
