package dev.eventchain.simulation.recording;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.messages.MessageType;
import dev.eventchain.simulation.bench.TypedTopic;
import dev.eventchain.simulation.host.NodeSession;
import dev.eventchain.simulation.scenario.Scenario;
import dev.eventchain.simulation.world.World;
import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/**
 * Recording of one scenario's messages and poses in an MCAP file with simulated time. The file has
 * a temporary name until it is complete.
 */
public final class Recording implements AutoCloseable {

  /** Suffix of the file's name. */
  static final String SUFFIX = ".mcap";

  private static final String UNFINISHED = ".part";

  /**
   * Recorded topics.
   *
   * @param published the topics that the world publishes, by the index of a message's topic
   * @param received the topics that the world receives, by the index of a message's topic
   * @param lidarFrame the frame of the lidar's messages; empty if there are none
   * @param epoch time on the clocks at time 0 of the scenario, in ns
   */
  public record Topics(
      List<TypedTopic> published, List<TypedTopic> received, String lidarFrame, long epoch) {

    /** Returns the time on the clocks at a time of the scenario, in ns. */
    private long shown(long time) {
      return epoch + time;
    }
  }

  private interface Writing {
    void run() throws IOException;
  }

  private final Path file;
  private final Path unfinished;
  private final Scenario scenario;
  private final Topics topics;
  private final SceneMessages scenes;
  private final Map<TypedTopic, Integer> channels = new HashMap<>();
  private OutputStream output = OutputStream.nullOutputStream();
  private McapWriter writer;
  private boolean closed;
  private int transforms;
  private int bodies;

  /**
   * Begins a recording.
   *
   * @param folder the folder of the file, which is named NAME.mcap
   * @param topics published and received topics, all of which are recorded
   * @throws DiagnosticException {@code simulation.recording.unwritable}, as from all methods
   */
  public Recording(
      Path folder, String name, Scenario scenario, Topics topics, MessageCatalog catalog) {
    this.file = folder.resolve(name + SUFFIX);
    this.unfinished = folder.resolve(name + SUFFIX + UNFINISHED);
    this.scenario = scenario;
    this.topics = topics;
    this.scenes = new SceneMessages(topics.lidarFrame());
    writing(() -> begin(catalog));
  }

  private void begin(MessageCatalog catalog) throws IOException {
    output = new BufferedOutputStream(Files.newOutputStream(unfinished), 1 << 16);
    writer = new McapWriter(output);
    List<TypedTopic> all = new ArrayList<>(topics.published());
    all.addAll(topics.received());
    for (TypedTopic topic : all) {
      if (!channels.containsKey(topic)) {
        MessageType type = catalog.find(topic.type()).orElseThrow();
        channels.put(topic, channel(topic.name(), type, catalog));
      }
    }
    boolean taken = all.stream().anyMatch(topic -> topic.name().equals("/tf"));
    transforms = channel(taken ? "/world/tf" : "/tf", scenes.transforms(), scenes.catalog());
    bodies = channel("/world/actors", scenes.bodies(), scenes.catalog());
  }

  private int channel(String topic, MessageType type, MessageCatalog catalog) throws IOException {
    return writer.channel(topic, type.name(), catalog.text(type));
  }

  /** Records the current poses. */
  public void scene(World world) {
    ScenePoses scene = ScenePoses.of(world, scenario.situation().ego());
    long now = topics.shown(world.now());
    writing(
        () -> {
          writer.message(transforms, now, ByteBuffer.wrap(scenes.transforms(scene, now)));
          writer.message(bodies, now, ByteBuffer.wrap(scenes.bodies(scene, now)));
        });
  }

  /** Records the messages that the world has just published, and the current poses. */
  public void sensed(World world, List<NodeSession.Inbound> messages) {
    scene(world);
    writing(
        () -> {
          for (NodeSession.Inbound message : messages) {
            TypedTopic topic = topics.published().get(message.topic());
            // The world also receives the messages on its own topics.
            if (!topics.received().contains(topic)) {
              writer.message(channels.get(topic), topics.shown(world.now()), message.message());
            }
          }
        });
  }

  /** Records a message of the nodes; calls are in the order of time. */
  public void took(NodeSession.Outbound message) {
    TypedTopic topic = topics.received().get(message.topic());
    long time = topics.shown(message.time());
    writing(() -> writer.message(channels.get(topic), time, message.message()));
  }

  /**
   * Completes the file.
   *
   * @param ended the end of the scenario, in words
   */
  public void finish(String ended) {
    TreeMap<String, String> about = new TreeMap<>();
    about.put("scenario", scenario.name());
    about.put("title", scenario.title());
    about.put("seed", Long.toString(scenario.seed()));
    about.put("ended", ended);
    writing(
        () -> {
          writer.metadata("eventchain", about);
          writer.finish();
          output.close();
          Files.move(unfinished, file);
        });
  }

  /**
   * Completes the file as {@link #finish} does, after a scenario that could not be driven to its
   * end.
   */
  public void finishAfter(DiagnosticException failure) {
    if (!closed) {
      try {
        finish(failure.diagnostics().get(0).id());
      } catch (DiagnosticException e) {
        failure.addSuppressed(e);
      }
    }
  }

  private void writing(Writing writing) {
    try {
      writing.run();
    } catch (IOException e) {
      close();
      throw new DiagnosticException(
          DiagnosticException.Reason.INPUT,
          Diagnostic.of(
                  RecordingRules.RECORDING_UNWRITABLE,
                  "The recording cannot be written: " + SourceText.reason(e) + ".",
                  SourceLocation.of(file))
              .withHint("Free some space, record fewer scenarios, or leave out --mcap."));
    }
  }

  /** Discards the file unless it is complete. */
  @Override
  public void close() {
    closed = true;
    try {
      output.close();
      Files.deleteIfExists(unfinished);
    } catch (IOException e) {
      // Its temporary name keeps it from being taken for a recording.
      return;
    }
  }
}
