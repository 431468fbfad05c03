package dev.eventchain.agents.prompt;

import dev.eventchain.model.eventchain.Data;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.SoftwareNode;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Objects;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.eclipse.emf.ecore.EObject;

/**
 * The names in event chains that constraints may refer to: components in chain order, and their
 * topics. Frequencies and budgets are left out, so that changing them needs no new constraints.
 */
public final class ModelNames {
  private ModelNames() {}

  public static String of(Collection<? extends EObject> model) {
    return model.stream()
        .filter(EventChain.class::isInstance)
        .map(EventChain.class::cast)
        .map(ModelNames::text)
        .collect(Collectors.joining("\n"));
  }

  private static String text(EventChain chain) {
    List<String> lines = new ArrayList<>();
    lines.add("The EventChain %s of these components, in this order:".formatted(chain.getName()));
    for (SoftwareNode node : chain.getSoftware()) {
      lines.add(
          "- %s reads %s, writes %s"
              .formatted(node.getName(), topics(node.getInput()), topics(node.getOutput())));
    }
    lines.add("Its requirements: " + ids(chain) + ".");
    return String.join("\n", lines);
  }

  private static String ids(EventChain chain) {
    return words(chain.getRequirements().stream().map(requirement -> requirement.getId()));
  }

  /** Returns each topic with the names of its values. */
  private static String topics(List<Data> data) {
    return words(
        data.stream()
            .map(Data::getTopicName)
            .distinct()
            .map(topic -> "%s (%s)".formatted(topic, values(data, topic))));
  }

  private static String values(List<Data> data, String topic) {
    return data.stream()
        .filter(value -> Objects.equals(topic, value.getTopicName()))
        .map(Data::getName)
        .collect(Collectors.joining(", "));
  }

  private static String words(Stream<String> words) {
    String all = words.collect(Collectors.joining(", "));
    return all.isEmpty() ? "nothing" : all;
  }
}
