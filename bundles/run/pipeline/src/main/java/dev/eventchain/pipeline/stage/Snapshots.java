package dev.eventchain.pipeline.stage;

import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import java.nio.file.Path;
import java.util.Collection;
import java.util.HashMap;
import java.util.Map;
import java.util.function.Supplier;

/**
 * A cache of objects read from files, each with the state of the files. Stages exchange files only:
 * a later stage gets an object of an earlier one only while its files are identical byte for byte.
 * Only the latest state is kept.
 */
final class Snapshots {

  private record Snapshot(String state, Object value) {}

  private final RunContext run;
  private final Map<String, Snapshot> latest = new HashMap<>();

  Snapshots(RunContext run) {
    this.run = run;
  }

  /**
   * Returns the object read from files.
   *
   * @param what the name of the object; one name always has the same type
   * @param files all files that it depends on, including missing ones
   * @param reader reads it; exceptions are not cached
   */
  @SuppressWarnings("unchecked")
  <T> T of(String what, Collection<Path> files, Supplier<T> reader) {
    String state = new Fingerprint(run).addFiles(files).value();
    Snapshot known = latest.get(what);
    if (known != null && known.state().equals(state)) {
      return (T) known.value();
    }
    T value =
        files.size() == 1
            ? DiagnosticException.at(SourceLocation.of(files.iterator().next()), reader)
            : reader.get();
    latest.put(what, new Snapshot(state, value));
    return value;
  }
}
