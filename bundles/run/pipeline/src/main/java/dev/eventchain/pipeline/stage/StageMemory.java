package dev.eventchain.pipeline.stage;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.ObjectMapper;
import dev.eventchain.output.OutputFolder;
import dev.eventchain.pipeline.run.Stage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;

/** Remembers stages in the output folder, a file each. */
public final class StageMemory {

  private static final ObjectMapper JSON = new ObjectMapper();

  private final OutputFolder output;
  private final Path base;

  /**
   * A memory.
   *
   * @param base where it is read; a run that only reads writes its output elsewhere
   */
  public StageMemory(OutputFolder output, Path base) {
    this.output = output;
    this.base = base;
  }

  /**
   * What is remembered of a stage that has ended. What cannot be read is forgotten: it only costs
   * running the stage again.
   */
  public Optional<StageRecord> recall(Stage stage) {
    try {
      byte[] bytes = bytes(stage);
      return bytes.length == 0
          ? Optional.empty()
          : Optional.of(JSON.readValue(bytes, StageRecord.class));
    } catch (IOException | RuntimeException e) {
      return Optional.empty();
    }
  }

  /** As {@link #recall(Stage)}, if what it read is the same and what it wrote is still there. */
  public Optional<StageRecord> recall(Stage stage, String key) {
    return recall(stage).filter(record -> record.key().equals(key)).filter(this::isThere);
  }

  private boolean isThere(StageRecord record) {
    return record.outputs().keySet().stream()
        .allMatch(name -> Files.isRegularFile(base.resolve(name)));
  }

  /** Whether a stage was begun and has not ended well: what it was to make is that of before. */
  public boolean isUnfinished(Stage stage) {
    try {
      return bytes(stage).length == 0;
    } catch (IOException e) {
      return false;
    }
  }

  private byte[] bytes(Stage stage) throws IOException {
    return Files.readAllBytes(base.resolve(name(stage)));
  }

  /** Forgets a stage, which is about to run, and then is unfinished until it is remembered. */
  public void forget(Stage stage) {
    output.write(name(stage), new byte[0], OutputFolder.OnEdit.OVERWRITE);
  }

  /** Remembers a stage that succeeded. */
  public void remember(Stage stage, StageRecord record) {
    try {
      output.write(name(stage), JSON.writeValueAsBytes(record), OutputFolder.OnEdit.OVERWRITE);
    } catch (JsonProcessingException e) {
      throw new IllegalStateException("a record of a stage is plain data", e);
    }
  }

  /**
   * Takes what is remembered of the files of stages into an output folder that has lost its own
   * records of them.
   *
   * @return whether anything is remembered
   */
  public boolean restoreRecords() {
    boolean any = false;
    for (Stage stage : Stage.values()) {
      Optional<StageRecord> record = recall(stage);
      record.ifPresent(found -> found.outputs().forEach(output::recall));
      any |= record.isPresent();
    }
    return any;
  }

  private static String name(Stage stage) {
    return ".stages/" + stage.id() + ".json";
  }
}
