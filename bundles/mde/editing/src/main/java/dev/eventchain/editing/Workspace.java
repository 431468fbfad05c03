package dev.eventchain.editing;

import dev.eventchain.diagnostics.SourceText;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.eclipse.emf.ecore.EPackage;

/**
 * The files of a workspace, as a {@link LanguageService} sees them. The same instances mean that
 * nothing has changed: an implementation keeps the text of a file until it changes, and the list of
 * metamodels, too. Thread-safe.
 */
public interface Workspace {

  /** Returns all files, in a stable order; also those that are open and not yet saved. */
  List<Path> files();

  /**
   * Returns a value that equals an earlier one only if no change of a file or of the list of files
   * has been noticed since.
   */
  default Object state() {
    return new Object();
  }

  /** Returns the text of a file: that of an open editor, or else of the disk; empty without one. */
  Optional<SourceText> text(Path file);

  /**
   * Returns the text of a file as {@link #text} does, without looking at a file again of which no
   * change was noticed: for who looks through all of them.
   */
  default Optional<SourceText> lastText(Path file) {
    return text(file);
  }

  /** Returns the metamodels that a file may name, outermost packages only, in a stable order. */
  List<EPackage> metamodels(Path file);

  /**
   * Returns the files that are checked together with a file although none names the other, such as
   * those of one project; with the file itself, and the same for each of them.
   */
  default Set<Path> checkedTogether(Path file) {
    return Set.of(file);
  }

  /** Returns the folders in which modules of templates are looked up by qualified names. */
  default List<Path> templateRoots(Path file) {
    return List.of();
  }
}
