package dev.eventchain.lsp.text;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Collection;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.eclipse.lsp4j.TextDocumentContentChangeEvent;

/** The texts that are open in the editor. Thread-safe. */
public final class OpenTexts {

  private final Map<Path, OpenText> open = new HashMap<>();

  /** The texts by all paths that lead to them; made anew after a change. */
  private Map<Path, String> overlay = Map.of();

  private Set<Path> paths = Set.of();
  private long revision;

  /** Opens a text; another one of the same file is closed. */
  public synchronized void open(OpenText text) {
    open.put(text.path(), text);
    paths = Set.copyOf(open.keySet());
    revision++;
    overlay = null;
  }

  /** Changes a text; changes of texts that are not open have no effect. */
  public synchronized void change(
      Path path, int version, List<TextDocumentContentChangeEvent> changes) {
    OpenText text = open.get(path);
    if (text != null) {
      for (TextDocumentContentChangeEvent change : changes) {
        text = text.with(version, change);
      }
      open.put(path, text);
      revision++;
      overlay = null;
    }
  }

  /** Closes a text: its file counts again. */
  public synchronized void close(Path path) {
    open.remove(path);
    paths = Set.copyOf(open.keySet());
    revision++;
    overlay = null;
  }

  /** Returns the open text of a file. */
  public synchronized Optional<OpenText> of(Path path) {
    return Optional.ofNullable(open.get(path));
  }

  /**
   * Returns how many columns the editor counts on the first line of a file before what the engine
   * reads: that of a byte order mark that it has kept, or none.
   */
  public int mark(Path path) {
    return of(path).filter(OpenText::hasMark).isPresent() ? 1 : 0;
  }

  /** Returns the files of all open texts; the same set until one is opened or closed. */
  public synchronized Set<Path> paths() {
    return paths;
  }

  /** Returns the number of changes of all kinds so far. */
  public synchronized long revision() {
    return revision;
  }

  /** Returns all open texts. */
  public synchronized Collection<OpenText> all() {
    return List.copyOf(open.values());
  }

  /** Returns the texts that the engine reads instead of files; does not change later. */
  public synchronized Map<Path, String> overlay() {
    if (overlay == null) {
      Map<Path, String> texts = new HashMap<>();
      for (OpenText text : open.values()) {
        texts.put(text.path(), text.withoutMark());
        texts.put(real(text.path()), text.withoutMark());
      }
      overlay = Map.copyOf(texts);
    }
    return overlay;
  }

  /** Returns the path without symbolic links, by which the engine may know the file. */
  private static Path real(Path path) {
    try {
      return path.toRealPath();
    } catch (IOException e) {
      return path; // not saved yet
    }
  }
}
