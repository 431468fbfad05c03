package dev.eventchain.lsp.language;

import dev.eventchain.check.Metamodels;
import dev.eventchain.diagnostics.Cancellation;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.diagnostics.UnsavedTexts;
import dev.eventchain.editing.FileState;
import dev.eventchain.editing.Workspace;
import dev.eventchain.lsp.check.Checks;
import dev.eventchain.lsp.check.WorkspaceFiles;
import dev.eventchain.lsp.text.OpenText;
import dev.eventchain.lsp.text.OpenTexts;
import dev.eventchain.project.ProjectFolder;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import org.eclipse.emf.ecore.EPackage;

/** The files and open texts of a session, as the services of languages see them. */
public final class EditorWorkspace implements Workspace {

  /**
   * A text, and what it was made from: an open text, or the state of a file.
   *
   * @param reports the reports of changes on disk before somebody last looked at the file
   */
  private record Known(Object state, SourceText text, long reports) {}

  /** A list of files, and what it was made from. */
  private record Listed(WorkspaceFiles found, Set<Path> open, List<Path> files) {}

  private record State(List<Path> files, long revision, long reports) {}

  /** Metamodels, and the texts that they were read from. */
  private record Loaded(List<SourceText> from, List<EPackage> packages) {}

  private final OpenTexts texts;
  private final Checks checks;
  private final Map<Path, Known> known = new HashMap<>();
  private Listed listed;
  private final Map<List<Path>, Loaded> loaded = new HashMap<>();

  /** Creates the workspace of a session. */
  public EditorWorkspace(OpenTexts texts, Checks checks) {
    this.texts = texts;
    this.checks = checks;
  }

  @Override
  public synchronized List<Path> files() {
    WorkspaceFiles found = checks.files();
    Set<Path> open = texts.paths();
    if (listed == null || listed.found() != found || listed.open() != open) {
      Set<Path> all = new TreeSet<>(found.all());
      all.addAll(open);
      listed = new Listed(found, open, List.copyOf(all));
    }
    return listed.files();
  }

  @Override
  public Object state() {
    return new State(files(), texts.revision(), checks.reports());
  }

  @Override
  public synchronized Optional<SourceText> text(Path file) {
    return text(file, checks.reports(), false);
  }

  /** Returns the text that is open, or else that of the disk when a change was last reported. */
  @Override
  public synchronized Optional<SourceText> lastText(Path file) {
    return text(file, checks.reports(), true);
  }

  private Optional<SourceText> text(Path file, long reports, boolean trusted) {
    Cancellation.check();
    Optional<OpenText> open = texts.of(file);
    Known before = known.get(file);
    boolean sameOnDisk = trusted && before != null && before.reports() == reports;
    if (sameOnDisk && open.isEmpty() && !(before.state() instanceof OpenText)) {
      return Optional.of(before.text());
    }
    Object state = open.isPresent() ? open.get() : FileState.of(file);
    if (before != null && before.state().equals(state)) {
      known.put(file, new Known(state, before.text(), reports));
      return Optional.of(before.text());
    }
    Optional<SourceText> text =
        open.map(each -> SourceText.of(file.toString(), each.withoutMark())).or(() -> read(file));
    text.ifPresentOrElse(
        it -> known.put(file, new Known(state, it, reports)), () -> known.remove(file));
    return text;
  }

  private static Optional<SourceText> read(Path file) {
    try {
      return Optional.of(SourceText.read(file));
    } catch (DiagnosticException e) {
      return Optional.empty(); // a finding says why
    }
  }

  @Override
  public synchronized List<EPackage> metamodels(Path file) {
    List<Path> ecores = checks.metamodels(file);
    List<SourceText> from = new ArrayList<>();
    ecores.forEach(each -> text(each).ifPresent(from::add));
    Loaded before = loaded.get(ecores);
    if (before == null || !isSame(before.from(), from)) {
      List<EPackage> packages = UnsavedTexts.during(texts.overlay(), () -> Metamodels.of(ecores));
      before = new Loaded(from, List.copyOf(packages));
      loaded.put(ecores, before);
    }
    return before.packages();
  }

  /** Returns the constraints of a project for each of them; others see only what they import. */
  @Override
  public Set<Path> checkedTogether(Path file) {
    return ProjectFolder.checkedTogether(file);
  }

  private static boolean isSame(List<SourceText> first, List<SourceText> second) {
    return first.equals(second); // texts are equal only to themselves
  }
}
