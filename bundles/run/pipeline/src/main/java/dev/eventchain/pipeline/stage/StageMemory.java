package dev.eventchain.pipeline.stage;

import dev.eventchain.output.OutputFolder;
import dev.eventchain.pipeline.results.ResultJson;
import dev.eventchain.pipeline.run.Stage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;

/** Records of stages in the output folder, a file each. */
public final class StageMemory {

  private final OutputFolder output;
  private final Path base;

  /**
   * Creates a memory.
   *
   * @param base the folder that it is read from; a read-only run writes its output elsewhere
   */
  public StageMemory(OutputFolder output, Path base) {
    this.output = output;
    this.base = base;
  }

  /**
   * Returns the record of a finished stage. Ignores unreadable records, such as those of other
   * versions of this program: they only cost another run of the stage.
   */
  public Optional<StageRecord> recall(Stage stage) {
    try {
      byte[] bytes = bytes(stage);
      return bytes.length == 0
          ? Optional.empty()
          : Optional.of(ResultJson.read(bytes, StageRecord.class, stage));
    } catch (IOException e) {
      return Optional.empty();
    }
  }

  /** As {@link #recall(Stage)}, if the inputs are the same and the outputs still exist. */
  public Optional<StageRecord> recall(Stage stage, Fingerprint inputs) {
    return recall(stage).filter(inputs::isOf).filter(this::isThere);
  }

  private boolean isThere(StageRecord record) {
    return record.outputs().keySet().stream()
        .allMatch(name -> Files.isRegularFile(base.resolve(name)));
  }

  /** Returns whether a stage was begun and did not succeed, so that its results are outdated. */
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

  /** Removes the record of a stage before it runs; it is unfinished until it is recorded again. */
  public void forget(Stage stage) {
    output.write(name(stage), new byte[0], OutputFolder.OnEdit.OVERWRITE);
  }

  /** Stores the record of a successful stage. */
  public void remember(Stage stage, StageRecord record) {
    output.write(name(stage), ResultJson.bytes(record), OutputFolder.OnEdit.OVERWRITE);
  }

  /**
   * Restores the records of an output folder that has lost them from the records of the stages.
   *
   * @return true if there are any records
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
