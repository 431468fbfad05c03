package dev.eventchain.pipeline;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.ObjectMapper;
import dev.eventchain.m2t.OutputFolder;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;

/** Remembers stages in the output folder, a file each. */
final class StageMemory {

  private static final ObjectMapper JSON = new ObjectMapper();

  private final OutputFolder output;
  private final Path base;

  StageMemory(OutputFolder output, Path base) {
    this.output = output;
    this.base = base;
  }

  /**
   * What is remembered of a stage, if what it read is the same and what it wrote is still there.
   * Whatever cannot be read is forgotten: it only costs running the stage again.
   */
  Optional<StageRecord> recall(Stage stage, String key) {
    return read(stage)
        .filter(record -> record.key().equals(key))
        .filter(
            record ->
                record.outputs().stream()
                    .allMatch(name -> Files.isRegularFile(base.resolve(name))));
  }

  private Optional<StageRecord> read(Stage stage) {
    try {
      byte[] bytes = output.read(name(stage)).orElse(new byte[0]);
      return bytes.length == 0
          ? Optional.empty()
          : Optional.of(JSON.readValue(bytes, StageRecord.class));
    } catch (IOException | RuntimeException e) {
      return Optional.empty();
    }
  }

  /** Forgets a stage, which then runs again. */
  void forget(Stage stage) {
    if (output.read(name(stage)).isPresent()) {
      output.write(name(stage), new byte[0], OutputFolder.OnEdit.OVERWRITE);
    }
  }

  /** Remembers a stage that succeeded. */
  void remember(Stage stage, StageRecord record) {
    try {
      output.write(name(stage), JSON.writeValueAsBytes(record), OutputFolder.OnEdit.OVERWRITE);
    } catch (JsonProcessingException e) {
      throw new IllegalStateException("a record of a stage is plain data", e);
    }
  }

  private static String name(Stage stage) {
    return ".stages/" + stage.id() + ".json";
  }
}
