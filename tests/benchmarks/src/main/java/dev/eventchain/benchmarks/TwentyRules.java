package dev.eventchain.benchmarks;

import dev.eventchain.model.eventchain.Data;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.LatencyConstraint;
import dev.eventchain.model.eventchain.SoftwareNode;
import java.util.ArrayList;
import java.util.Collection;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import org.eclipse.emf.common.util.TreeIterator;
import org.eclipse.emf.ecore.EObject;

/** The constraints of {@code twenty.ocl} in handwritten Java. */
final class TwentyRules {

  private final List<Violation> found = new ArrayList<>();
  private final List<SoftwareNode> allNodes = new ArrayList<>();

  private TwentyRules() {}

  /** Visits every element of a model. */
  static List<Violation> check(EObject root) {
    TwentyRules rules = new TwentyRules();
    List<EObject> elements = new ArrayList<>();
    elements.add(root);
    for (TreeIterator<EObject> all = root.eAllContents(); all.hasNext(); ) {
      EObject element = all.next();
      elements.add(element);
      if (element instanceof SoftwareNode node) {
        rules.allNodes.add(node);
      }
    }
    elements.forEach(rules::checkElement);
    return rules.found;
  }

  private void checkElement(EObject element) {
    if (element instanceof Data data) {
      checkData(data);
    } else if (element instanceof SoftwareNode node) {
      checkNode(node);
    } else if (element instanceof EventChain chain) {
      checkChain(chain);
    } else if (element instanceof LatencyConstraint constraint) {
      require(
          "EndsAreConnected",
          constraint.getMaximum() > 0.0
              && later(constraint.getFirst()).contains(constraint.getLast()),
          constraint);
    }
  }

  private void require(String rule, boolean holds, EObject element) {
    if (!holds) {
      found.add(new Violation(rule, element));
    }
  }

  private void checkChain(EventChain chain) {
    List<SoftwareNode> nodes = chain.getSoftware();
    require("NodeNamesDiffer", differ(nodes.stream().map(SoftwareNode::getName).toList()), chain);
    require("FourDataForANode", chain.getData().size() <= nodes.size() * 4, chain);
    double frequencies = 0.0;
    int longest = 0;
    Set<String> published = new HashSet<>();
    for (SoftwareNode node : nodes) {
      frequencies += node.getFrequency();
      longest = Math.max(longest, node.getName().length());
      node.getOutput().forEach(output -> published.add(output.getTopicName()));
    }
    require("NotTooBusy", frequencies <= nodes.size() * 20.0, chain);
    require("InputsArePublished", readOnly(published, nodes), chain);
    require("NamesAreShort", longest <= 64, chain);
    require("NodesAreHere", allNodes.stream().allMatch(n -> n.eContainer() == chain), chain);
  }

  private static boolean readOnly(Set<String> published, List<SoftwareNode> nodes) {
    for (SoftwareNode node : nodes) {
      for (Data input : node.getInput()) {
        if (!published.contains(input.getTopicName())) {
          return false;
        }
      }
    }
    return true;
  }

  private void checkNode(SoftwareNode node) {
    SoftwareNode next = node.getNextstep();
    double frequency = node.getFrequency();
    Set<SoftwareNode> later = later(node);
    String first = node.getName().substring(0, 1);
    double worst = node.getWorstCaseExecutionTime();
    require(
        "HasInputAndOutputData", !node.getInput().isEmpty() && !node.getOutput().isEmpty(), node);
    require(
        "NextstepFrequencyEqualOrHigher", next == null || next.getFrequency() >= frequency, node);
    require("NoCircle", !later.contains(node), node);
    require("LineIsShort", later.size() < 12, node);
    require("InputNamesDiffer", differ(node.getInput().stream().map(Data::getName).toList()), node);
    require("OutputTopicsDiffer", topicsDiffer(node.getOutput()), node);
    require("FrequencyInRange", frequency > 0.0 && frequency <= 1000.0, node);
    require("NextstepReadsWhatIsWritten", next == null || reads(next, node), node);
    require("NameStartsWithACapital", first.equals(first.toUpperCase(Locale.ROOT)), node);
    require("BestIsBelowWorst", node.getBestCaseExecutionTime() <= worst, node);
    require("FitsItsPeriod", worst <= (frequency > 0.0 ? 1000.0 / frequency : 0.0), node);
  }

  private static boolean reads(SoftwareNode next, SoftwareNode node) {
    for (Data output : node.getOutput()) {
      for (Data input : next.getInput()) {
        if (input.getTopicName().equals(output.getTopicName())) {
          return true;
        }
      }
    }
    return false;
  }

  private static boolean topicsDiffer(List<Data> outputs) {
    for (Data one : outputs) {
      for (Data other : outputs) {
        if (one != other && one.getTopicName().equals(other.getTopicName())) {
          return false;
        }
      }
    }
    return true;
  }

  private void checkData(Data data) {
    require("TopicIsAbsolute", data.getTopicName().startsWith("/"), data);
    require("HasNodesAndField", !allNodes.isEmpty() && !data.getFieldName().isEmpty(), data);
  }

  private static boolean differ(Collection<String> names) {
    return new HashSet<>(names).size() == names.size();
  }

  private static Set<SoftwareNode> later(SoftwareNode node) {
    Set<SoftwareNode> later = new LinkedHashSet<>();
    SoftwareNode step = node.getNextstep();
    while (step != null && later.add(step)) {
      step = step.getNextstep();
    }
    return later;
  }
}
