package dev.eventchain.workspace;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.documents.Document;
import dev.eventchain.documents.DocumentFormat;
import dev.eventchain.documents.DocumentRules;
import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.messages.RosNames;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SortedMap;
import java.util.TreeMap;

/**
 * A recording of topics: an MCAP file, or a folder that rosbag2 wrote. It says which topics there
 * were, with types, quality of service and rates; not which nodes wrote and read them.
 */
public final class Recording {

  /** Name of the description in a folder of rosbag2. */
  private static final String METADATA = "metadata.yaml";

  private static final String QOS = "offered_qos_profiles";
  private static final String SQLITE = ".db3";

  private static final String REINDEX =
      "`ros2 bag reindex FOLDER` writes a metadata.yaml that is missing.";

  private final Map<String, RecordedTopic> topics = new LinkedHashMap<>();
  private final SortedMap<String, String> definitions = new TreeMap<>();
  private final List<OpenQuestion> questions = new ArrayList<>();

  private Recording() {}

  /**
   * Reads a recording.
   *
   * @param path an MCAP file, or a folder with {@code metadata.yaml} and files in MCAP or SQLite
   * @throws DiagnosticException INPUT if it cannot be read, is neither, or has no topics ({@code
   *     workspace.recording})
   */
  public static Recording read(Path path) {
    Recording recording = new Recording();
    if (Files.isDirectory(path)) {
      recording.folder(path);
    } else if (path.toString().endsWith(SQLITE)) {
      throw refused(path, "it is a part of what rosbag2 wrote", "Name its folder. " + REINDEX);
    } else {
      recording.mcap(path, true);
    }
    if (recording.topics.isEmpty()) {
      throw refused(path, "it has no topic of ROS 2");
    }
    return recording;
  }

  /** Returns the topics, in the order of the recording. */
  List<RecordedTopic> topics() {
    return List.copyOf(topics.values());
  }

  /** Returns the average rates of topics in Hz, as far as they are known, by their names. */
  public Map<String, Double> rates() {
    Map<String, Double> rates = new LinkedHashMap<>();
    topics.values().stream()
        .filter(topic -> topic.rate() > 0)
        .forEach(topic -> rates.put(topic.name(), topic.rate()));
    return rates;
  }

  /** Returns the definitions of message types that it has, by their names. */
  SortedMap<String, String> definitions() {
    return definitions;
  }

  List<OpenQuestion> questions() {
    return questions;
  }

  private static DiagnosticException refused(Path path, String reason) {
    return refused(
        path, reason, "Name an MCAP file with a summary, or the folder that rosbag2 wrote.");
  }

  private static DiagnosticException refused(Path path, String reason, String hint) {
    return new DiagnosticException(
        DiagnosticException.Reason.INPUT,
        Diagnostic.of(
                WorkspaceRules.RECORDING,
                "This recording cannot be read: " + reason + ".",
                SourceLocation.of(path))
            .withHint(hint));
  }

  /** Adds what an MCAP file has: topics, or only definitions where these are known otherwise. */
  private void mcap(Path path, boolean withTopics) {
    try {
      McapSummary summary = McapSummary.read(path);
      for (McapSummary.Channel channel : summary.channels()) {
        Optional<McapSummary.Schema> schema = summary.schema(channel);
        boolean isRos = channel.encoding().equals("cdr") && schema.isPresent();
        if (isRos && schema.get().encoding().equals("ros2msg")) {
          define(schema.get().name(), schema.get().definition());
        }
        if (withTopics && isRos) {
          long count = summary.count(channel);
          add(
              new RecordedTopic(
                  channel.topic(),
                  RosNames.fullMessageType(schema.get().name()),
                  OfferedQos.read(channel.metadata().getOrDefault(QOS, "")),
                  count,
                  RecordedTopic.rate(count, summary.duration()),
                  SourceLocation.of(path).file()));
        } else if (withTopics) {
          String text = "What is '%s'? It is no topic of ROS 2.".formatted(channel.topic());
          questions.add(new OpenQuestion(text, SourceLocation.of(path).file(), 0));
        }
      }
    } catch (IOException e) {
      throw refused(path, SourceText.reason(e));
    } catch (MalformedFileException e) {
      throw refused(path, e.getMessage());
    }
  }

  private void folder(Path folder) {
    Path file = folder.resolve(METADATA);
    if (!Files.isRegularFile(file)) {
      throw refused(folder, "it has no " + METADATA, REINDEX);
    }
    DocumentRules rules = DocumentRules.all(WorkspaceRules.RECORDING);
    JsonNode root =
        Document.parse(SourceText.read(file), DocumentFormat.YAML, rules, found -> {}).root();
    JsonNode bag = root.path("rosbag2_bagfile_information");
    double duration = bag.path("duration").path("nanoseconds").asDouble() / 1e9;
    for (JsonNode each : bag.path("topics_with_message_count")) {
      add(topic(each, duration, SourceLocation.of(file).file()));
    }
    for (JsonNode relative : bag.path("relative_file_paths")) {
      Path part = folder.resolve(relative.asText()).normalize();
      if (part.startsWith(folder.normalize()) && Files.isRegularFile(part)) {
        if (relative.asText().endsWith(".mcap")) {
          mcap(part, false);
        } else if (relative.asText().endsWith(SQLITE)) {
          sqlite(part);
        }
      }
    }
  }

  /** Adds the definitions that a file in SQLite has; releases before Iron write none. */
  private void sqlite(Path path) {
    try (SqliteFile file = SqliteFile.open(path)) {
      for (Map<String, String> row : file.rows("message_definitions")) {
        if (row.getOrDefault("encoding", "").equals("ros2msg")) {
          define(
              row.getOrDefault("topic_type", ""),
              row.getOrDefault("encoded_message_definition", ""));
        }
      }
    } catch (IOException e) {
      throw refused(path, SourceText.reason(e));
    } catch (MalformedFileException e) {
      throw refused(path, e.getMessage());
    }
  }

  private static RecordedTopic topic(JsonNode json, double duration, String file) {
    JsonNode topic = json.path("topic_metadata");
    JsonNode qos = topic.path(QOS);
    long count = json.path("message_count").asLong();
    return new RecordedTopic(
        topic.path("name").asText(),
        RosNames.fullMessageType(topic.path("type").asText()),
        qos.isTextual() ? OfferedQos.read(qos.asText()) : OfferedQos.read(qos),
        count,
        RecordedTopic.rate(count, duration),
        file);
  }

  /** Adds a topic; services, actions and illegal names are no topics of a chain. */
  private void add(RecordedTopic topic) {
    if (RosNames.isTopic(topic.name()) && RosNames.isMessageType(topic.type())) {
      topics.putIfAbsent(topic.name(), topic);
    } else {
      String text = "What is '%s' of %s? It is no topic of ROS 2 that a chain can have.";
      questions.add(new OpenQuestion(text.formatted(topic.name(), topic.type()), topic.file(), 0));
    }
  }

  /** Adds a definition, and those of the types that it uses, which follow it. */
  private void define(String name, String text) {
    String[] parts = text.split("(?m)^=+\\R(?=MSG: )", -1);
    definitions.putIfAbsent(RosNames.fullMessageType(name), parts[0]);
    for (int i = 1; i < parts.length; i++) {
      String[] lines = parts[i].split("\\R", 2);
      String type = RosNames.fullMessageType(lines[0].substring("MSG: ".length()).strip());
      definitions.putIfAbsent(type, lines.length > 1 ? lines[1] : "");
    }
    definitions.keySet().removeIf(type -> !RosNames.isMessageType(type));
  }

  /** Returns a catalog of standard types, and those of the recording. */
  MessageCatalog catalog() {
    return MessageCatalog.ofTexts(definitions);
  }
}
