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
import java.util.Set;

/**
 * Output folder, through which all files are written. No file name leads out of it. A file appears
 * complete or not at all; a file that already has the content is not touched; a file with manual
 * changes is never replaced silently. The file {@code .eventchain/files.json} in the folder records
 * hashes of the written files.
 *
 * <p>File names are relative, with {@code /} between their parts. Safe for use by several threads.
 */
public final class OutputFolder implements AutoCloseable {

  /** Treatment of files with manual changes. */
  public enum OnEdit {
    /** Keep the changed file, with a warning. */
    KEEP,
    /** Replace the file, with a warning. */
    OVERWRITE
  }

  /** Outcome of writing a file. */
  public enum Outcome {
    /** Created or replaced. */
    WRITTEN,
    /** Already up to date. */
    UNCHANGED,
    /** Not written, because a changed or foreign file is in its place. */
    KEPT,
    /** Refused, because its name leads out of the folder or is invalid. */
    REFUSED
  }

  /**
   * Outcome of writing a file, with its finding.
   *
   * @param finding a warning {@code eventchain.file.edited} for a changed or foreign file that was
   *     kept or replaced, an error {@code output.path.refused} for a refused name
   */
  public record Written(Outcome outcome, Optional<Diagnostic> finding) {}

  /**
   * Order in which the files of a generation are written: first those with the content of lost
   * protected areas, so that a killed run loses none; then by name.
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
   * Opens or creates a folder and locks it against other runs until it is closed.
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
          Diagnostic.of(
                  OutputRules.OUTPUT_LOCKED,
                  "The output folder is in use by " + e.getMessage() + ".",
                  SourceLocation.of(base))
              .withHint("Wait for the other run to end, or choose another folder with -o."));
    } catch (IOException e) {
      throw OutputFindings.unwritable(base.toString(), e);
    }
  }

  /**
   * Returns an output folder in memory for tests.
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

  /**
   * Returns the files that runs have written below a folder, as its records say, also while another
   * run is writing there.
   *
   * @return names relative to the folder, sorted; none if it is no output folder
   * @throws IOException if the records cannot be read
   */
  public static Set<String> writtenBelow(Path folder) throws IOException {
    return StoredRecords.below(folder).files();
  }

  /** As {@link #write(String, byte[], OnEdit)}, keeping files with manual changes. */
  public Written write(String name, byte[] content) {
    return write(name, content, OnEdit.KEEP);
  }

  /**
   * Writes the content of a file.
   *
   * @throws DiagnosticException reason INPUT, {@code output.unwritable}, if the file system refuses
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
   * Returns whether lost areas are appended to the existing ones, some of which a user may have
   * removed.
   */
  private static boolean addsLostAreas(String path, byte[] present, byte[] content) {
    return path.endsWith(ProtectedAreas.LOST)
        && content.length > present.length
        && Arrays.equals(present, 0, present.length, content, 0, present.length);
  }

  /**
   * Returns the content of a file.
   *
   * @return empty if there is no such file or the name is refused
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
   * Returns whether there is a file with manual changes, or a foreign one. Changes inside protected
   * areas do not count.
   */
  public synchronized boolean isEdited(String name) {
    return read(name)
        .map(content -> !records.isOurs(OutputPath.of(name).value(), content))
        .orElse(false);
  }

  /**
   * Accepts a file unchanged, for a run that continues from a manually changed version.
   *
   * @return the warning {@code eventchain.file.edited} if it has manual changes; empty if it is as
   *     generated or does not exist
   */
  public synchronized Optional<Diagnostic> accept(String name) {
    return isEdited(name) ? Optional.of(kept(OutputPath.of(name).value())) : Optional.empty();
  }

  /**
   * Removes the files that earlier runs wrote below a folder and that are no longer produced.
   * Changed and foreign files stay, and those with protected areas.
   *
   * @param folder the name of the folder, or of a single file, relative to this one; "" for the
   *     whole folder
   * @param produced the names of all files below it that are still produced
   * @return a warning {@code eventchain.file.edited} for each changed file that was kept
   */
  public synchronized List<Diagnostic> removeOthers(String folder, Collection<String> produced) {
    return removal.others(folder, produced);
  }

  /**
   * Removes the files that a producer wrote in its latest run and no longer produces, and records
   * its current files. Files of other producers stay, and those that {@link #removeOthers} keeps.
   *
   * @param producer a unique id of the producer, such as the name of a build step
   * @return as {@link #removeOthers}
   */
  public synchronized List<Diagnostic> removeFormer(String producer, Collection<String> produced) {
    return removal.former(producer, produced);
  }

  /**
   * Returns a folder for files that are too large for {@link #write}, until {@link #move} puts them
   * in place. It is emptied when the output folder is opened again.
   */
  public synchronized Path scratch() {
    try {
      return storage.scratch();
    } catch (IOException e) {
      throw OutputFindings.unwritable(storage.shown(OutputPath.RESERVED), e);
    }
  }

  /**
   * Moves a finished file from {@link #scratch} into place, replacing any existing file.
   *
   * @return the warning {@code eventchain.file.edited} if it replaces a changed or foreign file
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
   * Removes outdated results of earlier runs.
   *
   * @param folder the name of their folder, or of a single file
   */
  public synchronized void removeAll(String folder) {
    removal.all(folder);
  }

  /**
   * Returns whether there are records of earlier runs. Without them, existing files that differ
   * count as foreign unless {@link #recall} restores their records.
   */
  public boolean hasRecords() {
    return !records.damaged() && !records.absent();
  }

  /**
   * Returns the fingerprint of the content last written to a file, for records kept elsewhere.
   *
   * @return a fingerprint of the content; empty if nothing was written there
   */
  public synchronized String written(String name) {
    return records.written(OutputPath.of(name).value());
  }

  /**
   * Restores the record of a file after the folder's own records were lost.
   *
   * @param fingerprint a result of {@link #written}
   */
  public synchronized void recall(String name, String fingerprint) {
    OutputPath path = OutputPath.of(name);
    if (!path.refused() && !fingerprint.isEmpty()) {
      records.put(path.value(), fingerprint);
    }
  }

  /**
   * Removes an outdated result, even if it was not generated.
   *
   * @return the warning {@code eventchain.file.edited} if it was changed or foreign
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
   * Returns a finding if the records of earlier runs were unreadable, so that existing files count
   * as foreign.
   */
  public Optional<Diagnostic> damage() {
    return records.damaged() ? Optional.of(findings.damaged()) : Optional.empty();
  }

  /** Writes the records of this folder and releases its lock. */
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
