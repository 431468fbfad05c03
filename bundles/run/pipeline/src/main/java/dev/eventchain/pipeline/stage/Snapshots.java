package dev.eventchain.pipeline.stage;

import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.FileReads;
import dev.eventchain.diagnostics.FileReads.Recorded;
import dev.eventchain.diagnostics.SourceLocation;
import java.nio.file.Path;
import java.util.Collection;
import java.util.HashMap;
import java.util.Map;
import java.util.SortedSet;
import java.util.function.Supplier;

/**
 * A cache of objects read from files, each with the state of the files. Stages exchange files only:
 * a later stage gets an object of an earlier one only while its files are identical byte for byte.
 * Only the latest state is kept.
 */
final class Snapshots {

  /** An object and the files that it was read from, with a hash of their content. */
  private record Snapshot(SortedSet<Path> files, String state, Object value) {}

  private final RunContext run;
  private final Map<String, Snapshot> latest = new HashMap<>();

  Snapshots(RunContext run) {
    this.run = run;
  }

  /**
   * Returns the object read from files.
   *
   * @param what the name of the object; one name always has the same type
   * @param files the files that it depends on, including missing ones, as far as they are known
   *     before it is read
   * @param reader reads it; exceptions are not cached
   */
  @SuppressWarnings("unchecked")
  <T> T of(String what, Collection<Path> files, Supplier<T> reader) {
    Snapshot known = latest.get(what);
    if (known != null && known.state().equals(state(files, known.files()))) {
      known.files().forEach(FileReads::note);
      return (T) known.value();
    }
    Recorded<T> read =
        FileReads.record(
            () ->
                files.size() == 1
                    ? DiagnosticException.at(SourceLocation.of(files.iterator().next()), reader)
                    : reader.get());
    latest.put(what, new Snapshot(read.files(), state(files, read.files()), read.value()));
    return read.value();
  }

  private String state(Collection<Path> files, Collection<Path> read) {
    return new Fingerprint(run).addFiles(files).addFiles(read).value();
  }
}
