package dev.eventchain.benchmarks;

import dev.eventchain.dds.DdsParticipant;
import dev.eventchain.dds.DdsReader;
import dev.eventchain.dds.DdsSample;
import dev.eventchain.dds.DdsWriter;
import dev.eventchain.messages.MessageType;
import dev.eventchain.messages.QosSettings;
import dev.eventchain.sandbox.PythonEnvironment;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;

/** A Python process on the network, with the topics to and from it. */
final class WirePeer implements AutoCloseable {

  static final Duration PATIENCE = Duration.ofSeconds(60);

  private final Process process;
  private final DdsWriter writer;
  private final DdsReader reader;

  private WirePeer(Process process, DdsWriter writer, DdsReader reader) {
    this.process = process;
    this.writer = writer;
    this.reader = reader;
  }

  /**
   * Starts Python with these arguments.
   *
   * @param output true if its output can be read here
   */
  static Process start(
      Path repository, PythonEnvironment python, String tag, boolean output, List<String> words)
      throws IOException {
    List<String> command = new ArrayList<>(List.of(python.executable().toString()));
    command.addAll(words);
    ProcessBuilder builder = new ProcessBuilder(command);
    builder.environment().put("CYCLONEDDS_URI", DdsParticipant.loopbackConfiguration(tag));
    builder.environment().put("ROS_DOMAIN_ID", "1");
    Path sources = repository.resolve("bundles/robot/runtime/python").toAbsolutePath();
    builder.environment().put("PYTHONPATH", sources.toString());
    builder.redirectError(ProcessBuilder.Redirect.INHERIT);
    if (!output) {
      builder.redirectOutput(ProcessBuilder.Redirect.DISCARD);
    }
    return builder.start();
  }

  /** Waits until the process and this one have discovered each other. */
  static WirePeer of(
      Process process,
      DdsParticipant here,
      String out,
      String back,
      MessageType type,
      QosSettings qos) {
    DdsWriter writer = here.writer(out, type, qos);
    // Messages that this side is too slow for do not count as losses of the other.
    DdsReader reader = here.reader(back, type, qos.withHistory(QosSettings.History.KEEP_ALL));
    if (!writer.waitForMatches(1, PATIENCE) || !reader.waitForMatches(1, PATIENCE)) {
      process.destroy();
      throw new IllegalStateException("the other process is not found");
    }
    return new WirePeer(process, writer, reader);
  }

  /** Sends until an answer arrives: the other side may not have discovered this one yet. */
  void greet(byte[] bytes) {
    for (int i = 0; i < 600; i++) {
      writer.write(bytes);
      if (!reader.take(Duration.ofMillis(100)).isEmpty()) {
        int answers = 0; // to earlier messages
        while (answers < 20 && !reader.take(Duration.ofMillis(300)).isEmpty()) {
          answers++;
        }
        return;
      }
    }
    throw new IllegalStateException("the other process does not answer");
  }

  /** Returns the processor time of the process's main thread, in ns; 0 if unknown here. */
  long processorTime() throws IOException {
    Path file = Path.of("/proc", Long.toString(process.pid()), "schedstat");
    return Files.exists(file) ? Long.parseLong(Files.readString(file).split(" ", -1)[0]) : 0;
  }

  boolean write(byte[] bytes) {
    return writer.write(bytes);
  }

  List<DdsSample> take(Duration timeout) {
    return reader.take(timeout);
  }

  /** Returns the round-trip time in ns. */
  long roundTrip(byte[] bytes) {
    long start = System.nanoTime();
    writer.write(bytes);
    List<DdsSample> samples = reader.take(PATIENCE);
    long taken = System.nanoTime() - start;
    if (samples.size() != 1 || samples.get(0).bytes().length != bytes.length) {
      throw new IllegalStateException(samples.size() + " samples came back");
    }
    return taken;
  }

  @Override
  public void close() {
    writer.close();
    reader.close();
    process.destroy();
    try {
      if (!process.waitFor(10, TimeUnit.SECONDS)) {
        process.destroyForcibly();
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
