package dev.eventchain.eclipse.ui.text;

import dev.eventchain.editing.FileEdit;
import dev.eventchain.editing.TextLines;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import org.eclipse.core.filebuffers.FileBuffers;
import org.eclipse.core.filebuffers.ITextFileBuffer;
import org.eclipse.core.filebuffers.ITextFileBufferManager;
import org.eclipse.core.filebuffers.LocationKind;
import org.eclipse.core.resources.IFile;
import org.eclipse.core.runtime.CoreException;
import org.eclipse.core.runtime.IPath;
import org.eclipse.core.runtime.IStatus;
import org.eclipse.core.runtime.Status;
import org.eclipse.jface.text.BadLocationException;
import org.eclipse.jface.text.IDocument;
import org.eclipse.text.edits.MalformedTreeException;
import org.eclipse.text.edits.MultiTextEdit;
import org.eclipse.text.edits.ReplaceEdit;
import org.eclipse.text.edits.UndoEdit;

/** The files of one renaming: all of them are changed, or none. */
final class RenamedFiles {

  private final Map<Path, String> seen;
  private final Map<Path, ITextFileBuffer> buffers = new LinkedHashMap<>();

  /** Those that had no unsaved changes. */
  private final Set<Path> clean = new HashSet<>();

  private final Set<Path> changed = new LinkedHashSet<>();
  private final Map<Path, UndoEdit> undo = new HashMap<>();

  /** Those that may have the new text on the disk. */
  private final Set<Path> written = new HashSet<>();

  /**
   * @param seen the texts for which the changes were found
   */
  RenamedFiles(Map<Path, String> seen) {
    this.seen = seen;
  }

  /** Changes all files, or none if one of them has another text by now or cannot be changed. */
  IStatus change(Map<Path, List<FileEdit>> edits) {
    try {
      for (Path file : edits.keySet()) {
        buffers.put(file, connect(file));
        if (!buffers.get(file).getDocument().get().equals(seen.get(file))) {
          return Status.error(file.getFileName() + " has changed meanwhile: nothing was renamed.");
        }
      }
      for (Map.Entry<Path, List<FileEdit>> each : edits.entrySet()) {
        change(each.getKey(), each.getValue());
      }
      for (Path file : changed) {
        if (clean.contains(file)) {
          written.add(file);
          buffers.get(file).commit(null, false);
        }
      }
      return Status.OK_STATUS;
    } catch (CoreException e) {
      return undone(e.getStatus().getMessage(), e);
    } catch (BadLocationException | MalformedTreeException e) {
      return undone("The changes do not fit the text.", e);
    } finally {
      buffers.keySet().forEach(RenamedFiles::disconnect);
    }
  }

  private static ITextFileBuffer connect(Path file) throws CoreException {
    ITextFileBufferManager manager = FileBuffers.getTextFileBufferManager();
    manager.connect(location(file), kind(file), null);
    return manager.getTextFileBuffer(location(file), kind(file));
  }

  private void change(Path file, List<FileEdit> edits) throws BadLocationException {
    ITextFileBuffer buffer = buffers.get(file);
    TextLines lines = new TextLines(buffer.getDocument().get());
    MultiTextEdit all = new MultiTextEdit();
    for (FileEdit each : edits) {
      int start = lines.offset(each.range().start());
      int length = lines.offset(each.range().end()) - start;
      all.addChild(new ReplaceEdit(start, length, each.newText()));
    }
    if (!buffer.isDirty()) {
      clean.add(file);
    }
    changed.add(file);
    undo.put(file, all.apply(buffer.getDocument()));
  }

  /** Gives all files their earlier texts, and names those that cannot be saved with them. */
  private IStatus undone(String reason, Exception cause) {
    changed.forEach(this::restore);
    String unsaved =
        changed.stream()
            .filter(file -> clean.contains(file) && !isSaved(file))
            .map(file -> file.getFileName().toString())
            .collect(Collectors.joining(", "));
    String result =
        unsaved.isEmpty()
            ? "Nothing was renamed."
            : "All texts are as before, but not all could be saved again; save or revert: "
                + unsaved;
    return Status.error(reason + "\n\n" + result, cause);
  }

  private void restore(Path file) {
    IDocument document = buffers.get(file).getDocument();
    try {
      if (undo.containsKey(file)) {
        undo.get(file).apply(document);
      }
    } catch (BadLocationException e) {
      document.set(seen.get(file)); // without the places of its markers
    }
    if (!document.get().equals(seen.get(file))) {
      document.set(seen.get(file));
    }
  }

  /** Saves a file that may be written already; else goes back to what the disk has. */
  private boolean isSaved(Path file) {
    try {
      if (written.contains(file)) {
        buffers.get(file).commit(null, false);
      } else {
        buffers.get(file).revert(null);
      }
      return true;
    } catch (CoreException e) {
      return false;
    }
  }

  private static void disconnect(Path file) {
    try {
      FileBuffers.getTextFileBufferManager().disconnect(location(file), kind(file), null);
    } catch (CoreException e) {
      return; // the buffer is not needed any more
    }
  }

  /** Returns the location by which editors know a file, so that their text is changed. */
  private static IPath location(Path file) {
    return Declarations.file(file)
        .map(IFile::getFullPath)
        .orElseGet(() -> IPath.fromOSString(file.toString()));
  }

  private static LocationKind kind(Path file) {
    return Declarations.file(file).isPresent() ? LocationKind.IFILE : LocationKind.LOCATION;
  }
}
