package dev.eventchain.lsp;

import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.editing.Analysis;
import dev.eventchain.editing.Workspace;
import dev.eventchain.fixtures.Repository;
import dev.eventchain.lsp.project.ProjectLanguageService;
import dev.eventchain.lsp.text.OpenTexts;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.eclipse.emf.ecore.EPackage;

/** A workspace with one text of an example, which is not saved; others are as on disk. */
record UnsavedText(Path opened, String text) implements Workspace {

  /** Returns what editors know of a text, whose cursor is marked by a circumflex. */
  static Analysis analysis(String file, String marked) {
    Path opened = Repository.ROOT.toAbsolutePath().normalize().resolve(file);
    UnsavedText only = new UnsavedText(opened, marked.replace("^", ""));
    return new ProjectLanguageService(only, new OpenTexts()).analysis(opened).orElseThrow();
  }

  @Override
  public List<Path> files() {
    return List.of();
  }

  @Override
  public Optional<SourceText> text(Path file) {
    return Optional.of(
        file.equals(opened) ? SourceText.of(file.toString(), text) : SourceText.read(file));
  }

  @Override
  public List<EPackage> metamodels(Path file) {
    return List.of();
  }
}
