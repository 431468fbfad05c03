package dev.eventchain.workspace;

import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import dev.eventchain.description.SoftwareBaseNames;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.documents.JsonLayout;
import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.messages.MessageType;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.SortedMap;
import java.util.TreeMap;

/**
 * The files of a software base for the topics of a recording: signals, the definitions of their
 * messages, and no components, since a recording does not say which nodes there were.
 */
public final class RecordedSignals {

  private final Recording recording;
  private final MessageCatalog catalog;
  private final MessageCatalog standard = MessageCatalog.of(List.of());
  private final List<OpenQuestion> questions;
  private final SortedMap<String, String> files = new TreeMap<>();

  private RecordedSignals(Recording recording) {
    this.recording = recording;
    this.catalog = recording.catalog();
    this.questions = new ArrayList<>(recording.questions());
  }

  /** Returns the texts of the files, by their paths in the project. */
  public static SortedMap<String, String> of(Recording recording) {
    return new RecordedSignals(recording).write();
  }

  private SortedMap<String, String> write() {
    MessageFields fields = new MessageFields(catalog);
    List<DescribedEndpoint> endpoints = new ArrayList<>();
    for (RecordedTopic topic : recording.topics()) {
      type(topic)
          .ifPresent(
              type -> {
                keep(type);
                ask(topic);
                endpoints.add(
                    new DescribedEndpoint(
                        false,
                        topic.name(),
                        topic.type(),
                        topic.qos(),
                        new LinkedHashSet<>(fields.all(type))));
              });
    }
    FoundNode reader =
        new FoundNode(
            "/reader", "", OptionalDouble.empty(), List.of(), true, Optional.empty(), "", 0);
    List<DescribedNode> all = List.of(new DescribedNode("Reader", reader, endpoints));
    files.put(SoftwareBaseNames.SIGNALS, SignalsJson.of(all, all));
    files.put(
        SoftwareBaseNames.COMPONENTS, JsonLayout.of(JsonNodeFactory.instance.arrayNode()) + "\n");
    files.put(SoftwareBaseNames.QUESTIONS, SoftwareBaseFiles.text(questions));
    return files;
  }

  private Optional<MessageType> type(RecordedTopic topic) {
    String problem = "The recording has no definition of it";
    try {
      Optional<MessageType> type = catalog.find(topic.type());
      if (type.isPresent()) {
        return type;
      }
    } catch (DiagnosticException e) {
      problem = e.diagnostics().get(0).message().replaceFirst("\\.$", "");
    }
    String text =
        "What is %s, the type of %s? %s; put it into software-base/msg, and the topic into signals.json."
            .formatted(topic.type(), topic.name(), problem);
    questions.add(new OpenQuestion(text, topic.file(), 0));
    return Optional.empty();
  }

  /** Adds definitions that are not standard, or not as in the default release. */
  private void keep(MessageType type) {
    String definition = recording.definitions().get(type.name());
    if (definition != null && !standard.find(type.name()).filter(type::equals).isPresent()) {
      files.put(SoftwareBaseNames.MESSAGES + "/" + type.name() + ".msg", definition);
    }
    type.fields().forEach(field -> field.type().message().ifPresent(this::keep));
  }

  private void ask(RecordedTopic topic) {
    String rate = topic.rate() > 0 ? ", " + topic.rate() + " Hz on average" : "";
    String text =
        String.format(
            Locale.ROOT,
            "Who writes and who reads %s (%d messages%s)? The vehicle is taken to provide it.",
            topic.name(),
            topic.count(),
            rate);
    questions.add(new OpenQuestion(text, topic.file(), 0));
    if (topic.qos().isEmpty()) {
      String unknown = "What is the quality of service of %s? The recording does not say.";
      questions.add(new OpenQuestion(unknown.formatted(topic.name()), topic.file(), 0));
    }
  }
}
