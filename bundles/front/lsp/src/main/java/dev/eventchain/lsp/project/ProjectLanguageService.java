package dev.eventchain.lsp.project;

import dev.eventchain.editing.Analysis;
import dev.eventchain.editing.Call;
import dev.eventchain.editing.LanguageService;
import dev.eventchain.editing.Workspace;
import dev.eventchain.lsp.text.OpenTexts;
import dev.eventchain.project.ProjectFolder;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/** Language service for the YAML, JSON, Markdown and models of a project. */
public final class ProjectLanguageService implements LanguageService {

  private final Workspace workspace;
  private final OpenTexts texts;
  private final ProjectSchemas schemas = new ProjectSchemas();

  /** The service for the projects of a session. */
  public ProjectLanguageService(Workspace workspace, OpenTexts texts) {
    this.workspace = workspace;
    this.texts = texts;
  }

  @Override
  public boolean handles(Path file) {
    return file.toString().matches(".*\\.(ya?ml|md|json|xmi|eventchain)");
  }

  @Override
  public Optional<Analysis> analysis(Path file) {
    return ProjectFolder.around(file)
        .flatMap(
            folder ->
                workspace
                    .text(file)
                    .map(
                        text ->
                            new ProjectText(
                                file, text, new ProjectFiles(workspace, texts, folder), schemas)));
  }

  @Override
  public List<Call> incomingCalls(Call.Item item) {
    return List.of();
  }

  @Override
  public List<Call> outgoingCalls(Call.Item item) {
    return List.of();
  }
}
