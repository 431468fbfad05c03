package dev.eventchain.eclipse;

import dev.eventchain.check.Metamodels;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.editing.FileState;
import dev.eventchain.editing.Workspace;
import dev.eventchain.project.ProjectFolder;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicLong;
import org.eclipse.core.resources.IProject;
import org.eclipse.core.resources.IResourceChangeEvent;
import org.eclipse.core.resources.ResourcesPlugin;
import org.eclipse.core.runtime.CoreException;
import org.eclipse.emf.ecore.EPackage;

/**
 * The rules, templates and metamodels of an Eclipse project, with the texts of editors instead of
 * those on the disk.
 */
final class CodeWorkspace implements Workspace {

  /** Number of changes in Eclipse's workspace so far, for all that is kept until the next one. */
  private static final AtomicLong CHANGES = new AtomicLong();

  static {
    ResourcesPlugin.getWorkspace()
        .addResourceChangeListener(
            event -> CHANGES.incrementAndGet(), IResourceChangeEvent.POST_CHANGE);
  }

  /**
   * A text, and the state of the file that it was read from.
   *
   * @param changes the number of changes before somebody last looked at the file
   */
  private record Known(FileState state, SourceText text, long changes) {}

  /** The files after a number of changes. */
  private record Listed(long changes, List<Path> texts, List<Path> ecores) {}

  /** All files, and what the list was made from. */
  private record All(Listed listed, Set<Path> open, List<Path> files) {}

  private record State(long changes, long edits, List<Path> files) {}

  /** Metamodels, and the texts that they were read from. */
  private record Loaded(List<SourceText> from, List<EPackage> packages) {}

  private final Optional<IProject> project;
  private final Map<Path, SourceText> open = new ConcurrentHashMap<>();
  private final Map<Path, Known> known = new HashMap<>();

  /** Number of changes of open texts so far; counted after each of them. */
  private final AtomicLong edits = new AtomicLong();

  private Listed listed = new Listed(-1, List.of(), List.of());
  private All all = new All(listed, Set.of(), List.of());
  private Loaded loaded;

  /**
   * @param project empty for files outside of Eclipse's workspace
   */
  CodeWorkspace(Optional<IProject> project) {
    this.project = project;
  }

  /** Takes the text of an editor; the same text stays the same instance. */
  void open(Path file, String text) {
    open.compute(
        file,
        (path, before) ->
            before != null && before.text().equals(text)
                ? before
                : SourceText.of(path.toString(), text));
    edits.incrementAndGet();
  }

  /** Goes back to the text on the disk. */
  void close(Path file) {
    open.remove(file);
    edits.incrementAndGet();
  }

  private synchronized Listed listed() {
    long changes = CHANGES.get();
    if (listed.changes() != changes && project.isPresent()) {
      try {
        CheckedFiles found = CheckedFiles.of(project.get());
        listed = new Listed(changes, found.texts(), found.ecores());
      } catch (CoreException e) {
        listed = new Listed(changes, List.of(), List.of()); // closed meanwhile
      }
    }
    return listed;
  }

  @Override
  public synchronized List<Path> files() {
    Listed found = listed();
    Set<Path> opened = Set.copyOf(open.keySet());
    if (all.listed() != found || !all.open().equals(opened)) {
      Set<Path> both = new TreeSet<>(found.texts());
      both.addAll(opened);
      all = new All(found, opened, List.copyOf(both));
    }
    return all.files();
  }

  @Override
  public Object state() {
    return new State(CHANGES.get(), edits.get(), files());
  }

  @Override
  public synchronized Optional<SourceText> text(Path file) {
    SourceText edited = open.get(file);
    if (edited != null) {
      return Optional.of(edited);
    }
    long changes = CHANGES.get();
    FileState state = FileState.of(file);
    Known before = known.get(file);
    if (before != null && before.state().equals(state)) {
      known.put(file, new Known(state, before.text(), changes));
      return Optional.of(before.text());
    }
    known.remove(file);
    if (state.isFile()) {
      read(file).ifPresent(text -> known.put(file, new Known(state, text, changes)));
    }
    return Optional.ofNullable(known.get(file)).map(Known::text);
  }

  /** Returns the text that is open, or else that of the disk when Eclipse last noticed a change. */
  @Override
  public synchronized Optional<SourceText> lastText(Path file) {
    Known before = known.get(file);
    return before != null && before.changes() == CHANGES.get() && !open.containsKey(file)
        ? Optional.of(before.text())
        : text(file);
  }

  private static Optional<SourceText> read(Path file) {
    try {
      return Optional.of(SourceText.read(file));
    } catch (DiagnosticException e) {
      return Optional.empty(); // a marker says why
    }
  }

  /** Returns those that the checks of the project use. */
  @Override
  public synchronized List<EPackage> metamodels(Path file) {
    List<Path> ecores = listed().ecores();
    List<SourceText> from = new ArrayList<>();
    ecores.forEach(each -> text(each).ifPresent(from::add));
    if (loaded == null || !loaded.from().equals(from)) { // texts are equal only to themselves
      loaded = new Loaded(from, List.copyOf(Metamodels.of(ecores)));
    }
    return loaded.packages();
  }

  /** Returns the constraints of an Eventchain project for each of them. */
  @Override
  public Set<Path> checkedTogether(Path file) {
    return ProjectFolder.checkedTogether(file);
  }
}
