package dev.eventchain.output;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Collection;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * The only way to write files. Nothing gets outside the folder, whatever a name says; a file
 * appears complete or not at all; a file that already has the content is not touched; and a file
 * that a person changed is never replaced silently. What was written is remembered in {@code
 * .eventchain/files.json} inside the folder.
 *
 * <p>File names are relative, with {@code /} between their parts. Safe for use by several threads.
 */
public final class OutputFolder implements AutoCloseable {

  /** What to do with a file that a person changed since it was written. */
  public enum OnEdit {
    /** Leave the person's file, and warn. */
    KEEP,
    /** Replace it, and say so. */
    OVERWRITE
  }

  /** What became of a file. */
  public enum Outcome {
    /** It was created or replaced. */
    WRITTEN,
    /** It held the content already. */
    UNCHANGED,
    /** A person's file is in its place. */
    KEPT,
    /** Its name leads out of the folder or cannot be a file's. */
    REFUSED
  }

  /**
   * What became of a file, and the finding that goes with it.
   *
   * @param finding a warning {@code eventchain.file.edited} for a person's file that was kept or
   *     replaced, an error {@code output.path.refused} for a refused name
   */
  public record Written(Outcome outcome, Optional<Diagnostic> finding) {}

  /**
   * The order in which the files of a generation are written: first those that save what people
   * wrote in areas that are no longer generated, so that a killed run loses none; then by name.
   */
  public static final Comparator<String> WRITING_ORDER =
      (one, other) -> {
        boolean lost = one.endsWith(ProtectedAreas.LOST);
        if (lost != other.endsWith(ProtectedAreas.LOST)) {
          return lost ? -1 : 1;
        }
        return one.compareTo(other);
      };

  private final OutputStorage storage;
  private final FileRecords records;
  private final OutputFindings findings;
  private final Removal removal;
  private boolean closed;

  private OutputFolder(OutputStorage storage, FileRecords records) {
    this.storage = storage;
    this.records = records;
    this.findings = new OutputFindings(storage);
    this.removal = new Removal(storage, records, findings);
  }

  /**
   * Opens a folder, creating it, and keeps other runs out until it is closed.
   *
   * @throws DiagnosticException reason INPUT: {@code output.unwritable}, or {@code output.locked}
   *     naming the process that is writing there
   */
  public static OutputFolder open(Path base) {
    try {
      FolderStorage storage = FolderStorage.open(base);
      return new OutputFolder(storage, new FileRecords(storage));
    } catch (FolderLock.HeldException e) {
      throw OutputFindings.failure(
          Diagnostic.error(
                  "output.locked",
                  "The output folder is in use by " + e.getMessage() + ".",
                  SourceLocation.of(base))
              .withHint("Wait for the other run to end, or choose another folder with -o."));
    } catch (IOException e) {
      throw OutputFindings.unwritable(base.toString(), e);
    }
  }

  /**
   * The double of a folder for tests.
   *
   * @param files the content of the folder by name, read and changed in place
   */
  public static OutputFolder inMemory(Map<String, byte[]> files) {
    try {
      MemoryStorage storage = new MemoryStorage(files);
      return new OutputFolder(storage, new FileRecords(storage));
    } catch (IOException e) {
      throw OutputFindings.unwritable("memory", e);
    }
  }

  /** As {@link #write(String, byte[], OnEdit)}, keeping a file that a person changed. */
  public Written write(String name, byte[] content) {
    return write(name, content, OnEdit.KEEP);
  }

  /**
   * Makes a file hold a content.
   *
   * @throws DiagnosticException reason INPUT, {@code output.unwritable}, if the disk refuses
   */
  public synchronized Written write(String name, byte[] content, OnEdit onEdit) {
    OutputPath path = OutputPath.of(name);
    if (path.refused()) {
      return new Written(Outcome.REFUSED, Optional.of(findings.refusedHere(name, path)));
    }
    try {
      return put(path.value(), content, onEdit);
    } catch (FolderStorage.LinkLeavesFolderException e) {
      return new Written(Outcome.REFUSED, Optional.of(findings.linkRefused(path.value(), e)));
    } catch (IOException e) {
      throw OutputFindings.unwritable(storage.shown(path.value()), e);
    }
  }

  private Written put(String path, byte[] content, OnEdit onEdit) throws IOException {
    Optional<byte[]> present = storage.read(path);
    String fingerprint = FileRecords.fingerprint(content);
    if (present.isPresent() && Arrays.equals(present.get(), content)) {
      records.put(path, fingerprint);
      return new Written(Outcome.UNCHANGED, Optional.empty());
    }
    Optional<Diagnostic> finding = Optional.empty();
    if (present.isPresent()
        && !records.isOurs(path, present.get())
        && !addsLostAreas(path, present.get(), content)) {
      if (onEdit == OnEdit.KEEP) {
        return new Written(Outcome.KEPT, Optional.of(kept(path)));
      }
      finding = Optional.of(findings.overwritten(path));
    }
    records.announce(path, fingerprint);
    storage.replace(path, content);
    records.put(path, fingerprint);
    return new Written(Outcome.WRITTEN, finding);
  }

  private Diagnostic kept(String path) {
    return findings.kept(path, !records.written(path).isEmpty());
  }

  /**
   * Whether lost areas are appended to the existing ones, some of which a person may have removed.
   */
  private static boolean addsLostAreas(String path, byte[] present, byte[] content) {
    return path.endsWith(ProtectedAreas.LOST)
        && content.length > present.length
        && Arrays.equals(present, 0, present.length, content, 0, present.length);
  }

  /**
   * The content of a file.
   *
   * @return nothing if there is no such file or the name is refused
   */
  public synchronized Optional<byte[]> read(String name) {
    OutputPath path = OutputPath.of(name);
    if (path.refused()) {
      return Optional.empty();
    }
    try {
      return storage.read(path.value());
    } catch (FolderStorage.LinkLeavesFolderException e) {
      return Optional.empty();
    } catch (IOException e) {
      throw OutputFindings.unwritable(storage.shown(path.value()), e);
    }
  }

  /**
   * Whether there is a file that is not as we wrote it: a person changed it, or put it there.
   * Changes inside protected areas do not count, they are what the areas are for.
   */
  public synchronized boolean isEdited(String name) {
    return read(name)
        .map(content -> !records.isOurs(OutputPath.of(name).value(), content))
        .orElse(false);
  }

  /**
   * Accepts a file as it is, for a run that continues from a person's version of it.
   *
   * @return the warning {@code eventchain.file.edited} if a person changed it; nothing if it is as
   *     we wrote it or does not exist
   */
  public synchronized Optional<Diagnostic> accept(String name) {
    return isEdited(name) ? Optional.of(kept(OutputPath.of(name).value())) : Optional.empty();
  }

  /**
   * Removes the files that earlier runs wrote below a folder and that are no longer produced. Files
   * that a person changed or put there stay, and those that have protected areas.
   *
   * @param folder the name of the folder, or of a single file, relative to this one; "" is
   *     everything
   * @param produced the names of all files below it that are still produced
   * @return a warning {@code eventchain.file.edited} for each file that was left for a person's
   *     sake
   */
  public synchronized List<Diagnostic> removeOthers(String folder, Collection<String> produced) {
    return removal.others(folder, produced);
  }

  /**
   * Removes what one producer wrote in its latest run and no longer produces, and remembers what it
   * produces now. Other producers' files in this folder stay, and those that {@link #removeOthers}
   * leaves.
   *
   * @param producer what tells it from others, such as the name of a step in a build
   * @return as {@link #removeOthers}
   */
  public synchronized List<Diagnostic> removeFormer(String producer, Collection<String> produced) {
    return removal.former(producer, produced);
  }

  /**
   * A folder for files that are too large for {@link #write}, until {@link #move} puts them in
   * place. What is left in it is gone when the output folder is opened again.
   */
  public synchronized Path scratch() {
    try {
      return storage.scratch();
    } catch (IOException e) {
      throw OutputFindings.unwritable(storage.shown(OutputPath.RESERVED), e);
    }
  }

  /**
   * Puts a finished file of {@link #scratch} in place, whatever is there, as a result of the run.
   *
   * @return the warning {@code eventchain.file.edited} if it replaces what we did not write there
   */
  public synchronized Written move(Path finished, String name) {
    OutputPath path = OutputPath.of(name);
    if (path.refused()) {
      return new Written(Outcome.REFUSED, Optional.of(findings.refusedHere(name, path)));
    }
    try {
      Optional<Path> present = storage.find(path.value());
      boolean foreign =
          present.isPresent()
              && !records.isOurs(path.value(), FileRecords.fingerprint(present.get()));
      String fingerprint = FileRecords.fingerprint(finished);
      records.announce(path.value(), fingerprint);
      storage.move(finished, path.value());
      records.put(path.value(), fingerprint);
      return new Written(
          Outcome.WRITTEN,
          foreign ? Optional.of(findings.overwritten(path.value())) : Optional.empty());
    } catch (FolderStorage.LinkLeavesFolderException e) {
      return new Written(Outcome.REFUSED, Optional.of(findings.linkRefused(path.value(), e)));
    } catch (IOException e) {
      throw OutputFindings.unwritable(storage.shown(path.value()), e);
    }
  }

  /**
   * Removes results that earlier runs wrote and that no longer hold.
   *
   * @param folder the name of the folder that they are in, or of a single one
   */
  public synchronized void removeAll(String folder) {
    removal.all(folder);
  }

  /**
   * Whether there are records of what earlier runs wrote. Without them, existing files that differ
   * count as people's, unless {@link #recall} says otherwise.
   */
  public boolean hasRecords() {
    return !records.damaged() && !records.absent();
  }

  /**
   * What a file was given last, for those who remember it elsewhere, too.
   *
   * @return a fingerprint of the content; empty if nothing was written there
   */
  public synchronized String written(String name) {
    return records.written(OutputPath.of(name).value());
  }

  /**
   * Takes in what a file was given last, where the folder's own records are lost.
   *
   * @param fingerprint as {@link #written} gave it
   */
  public synchronized void recall(String name, String fingerprint) {
    OutputPath path = OutputPath.of(name);
    if (!path.refused() && !fingerprint.isEmpty()) {
      records.put(path.value(), fingerprint);
    }
  }

  /**
   * Removes a result that no longer holds, whoever wrote it.
   *
   * @return the warning {@code eventchain.file.edited} if a person had changed it
   */
  public synchronized Optional<Diagnostic> remove(String name) {
    OutputPath path = OutputPath.of(name);
    if (path.refused()) {
      return Optional.of(findings.refusedHere(name, path));
    }
    Optional<Diagnostic> finding =
        isEdited(name) ? Optional.of(findings.removed(path.value())) : Optional.empty();
    try {
      storage.delete(path.value());
      records.remove(path.value());
      return finding;
    } catch (FolderStorage.LinkLeavesFolderException e) {
      return Optional.of(findings.linkRefused(path.value(), e));
    } catch (IOException e) {
      throw OutputFindings.unwritable(storage.shown(path.value()), e);
    }
  }

  /**
   * Whether the records of earlier runs were unreadable, so that existing files count as people's.
   */
  public Optional<Diagnostic> damage() {
    return records.damaged() ? Optional.of(findings.damaged()) : Optional.empty();
  }

  /** Writes the records of this folder and lets other runs in. */
  @Override
  public synchronized void close() {
    if (closed) {
      return;
    }
    closed = true;
    try {
      try {
        records.save();
      } finally {
        storage.close();
      }
    } catch (IOException e) {
      throw OutputFindings.unwritable(storage.shown(OutputPath.RESERVED), e);
    }
  }
}
