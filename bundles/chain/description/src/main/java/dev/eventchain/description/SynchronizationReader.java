package dev.eventchain.description;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.NearestName;
import dev.eventchain.documents.Document;
import dev.eventchain.documents.NumberRange;
import dev.eventchain.documents.ObjectReader;
import dev.eventchain.jsonmodels.Names;
import dev.eventchain.messages.RosNames;
import dev.eventchain.model.TopicIndex;
import dev.eventchain.model.eventchain.Data;
import dev.eventchain.model.eventchain.SoftwareNode;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Reader of which inputs of a component belong together. A description names topics, since messages
 * are synchronized; the model refers to all inputs from them.
 */
final class SynchronizationReader {

  private SynchronizationReader() {}

  /** Reads the synchronized topics and the tolerance of a component whose inputs are known. */
  static void read(ObjectReader json, Document text, SoftwareNode node) {
    Map<String, List<Data>> inputs = new LinkedHashMap<>();
    for (Data input : node.getInput()) {
      TopicIndex.nameOf(input, node)
          .ifPresent(it -> inputs.computeIfAbsent(it, none -> new ArrayList<>()).add(input));
    }
    List<String> topics = json.texts(ChainNames.SYNCHRONIZED);
    for (int i = 0; i < topics.size(); i++) {
      String topic = RosNames.resolve(topics.get(i), RosNames.nodeName(node.getName()));
      if (inputs.containsKey(topic)) {
        node.getSynchronized().addAll(inputs.get(topic));
      } else {
        json.find(
            Diagnostic.of(
                    DescriptionRules.SYNCHRONIZED_UNKNOWN,
                    "The component has no input from '" + Names.printable(topics.get(i)) + "'.",
                    text.at(Document.below(json.pointerTo(ChainNames.SYNCHRONIZED), i)))
                .withHint(NearestName.hint(topics.get(i), inputs.keySet())));
      }
    }
    json.number(ChainNames.TOLERANCE, NumberRange.above(0)).ifPresent(node::setTolerance);
  }
}
