package dev.eventchain.output;

import dev.eventchain.diagnostics.Sha256;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Collection;
import java.util.List;

/** Files that one of several producers wrote into an output folder in its latest run. */
final class ProducedFiles {

  private final OutputStorage storage;
  private final String list;

  /**
   * Creates the record of a producer.
   *
   * @param producer any text
   */
  ProducedFiles(OutputStorage storage, String producer) {
    this.storage = storage;
    String name = new Sha256().add(producer.getBytes(StandardCharsets.UTF_8)).hex();
    list = OutputPath.RESERVED + "/produced-" + name.substring(0, 16) + ".txt";
  }

  /** Returns the files of its latest run; none before its first run. */
  List<String> former() {
    try {
      return storage
          .read(list)
          .map(bytes -> new String(bytes, StandardCharsets.UTF_8).lines())
          .stream()
          .flatMap(lines -> lines)
          .filter(name -> !OutputPath.of(name).refused())
          .toList();
    } catch (IOException e) {
      throw OutputFindings.unwritable(storage.shown(list), e);
    }
  }

  /** Stores the files of this run for the next one. */
  void remember(Collection<String> files) {
    try {
      byte[] content = String.join("\n", files).getBytes(StandardCharsets.UTF_8);
      storage.replace(list, content);
    } catch (IOException e) {
      throw OutputFindings.unwritable(storage.shown(list), e);
    }
  }
}
