package dev.eventchain.pipeline.stage;

import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import java.nio.file.Path;
import java.util.Collection;
import java.util.HashMap;
import java.util.Map;
import java.util.function.Supplier;

/**
 * What was read of files, or made of that, each with the state of the files then. Stages pass files
 * to each other and nothing else: a later stage gets what an earlier one has read only while the
 * files are the same, byte for byte. Only the latest state is kept.
 */
final class Snapshots {

  private record Snapshot(String state, Object value) {}

  private final RunContext run;
  private final Map<String, Snapshot> latest = new HashMap<>();

  Snapshots(RunContext run) {
    this.run = run;
  }

  /**
   * What the files say.
   *
   * @param what names it; the same name always goes with the same type
   * @param files all files that it depends on; such that are not there count, too
   * @param reader reads it; what it throws is not kept
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
