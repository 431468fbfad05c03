package dev.eventchain.eclipse.ui.editor.model;

import dev.eventchain.model.eventchain.ChainMeasurement;
import dev.eventchain.model.eventchain.Data;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.EventchainPackage;
import dev.eventchain.model.eventchain.LatencyConstraint;
import dev.eventchain.model.eventchain.LatencyMeasurement;
import dev.eventchain.model.eventchain.LatencyPart;
import dev.eventchain.model.eventchain.Measurement;
import dev.eventchain.model.eventchain.NodeMeasurement;
import dev.eventchain.model.eventchain.Processor;
import dev.eventchain.model.eventchain.QosProfile;
import dev.eventchain.model.eventchain.Requirement;
import dev.eventchain.model.eventchain.SoftwareNode;
import dev.eventchain.model.eventchain.Statistics;
import java.util.Locale;
import org.eclipse.emf.ecore.EObject;

/** Labels of elements in the tree and the lists of the editor. */
public final class Labels {

  private static final EventchainPackage MODEL = EventchainPackage.eINSTANCE;

  private Labels() {}

  /** A name with details, which may be empty. */
  public record Label(String name, String details) {

    /** Returns name and details, as searchable text. */
    public String text() {
      return details.isEmpty() ? name : name + "  " + details;
    }
  }

  public static Label of(Object element) {
    if (element instanceof Group group) {
      boolean unused = group.feature() == MODEL.getEventChain_Data();
      return new Label(unused ? "Unused data" : Words.of(group.feature()), "");
    } else if (element instanceof EventChain chain) {
      return new Label(named(chain.getName(), chain), "");
    } else if (element instanceof SoftwareNode node) {
      String rate = node.isSetFrequency() ? number(node.getFrequency()) + " Hz" : "";
      return new Label(named(node.getName(), node), rate);
    } else if (element instanceof Data data) {
      return new Label(named(data.getName(), data), signal(data));
    } else if (element instanceof Requirement requirement) {
      return new Label(named(requirement.getId(), requirement), text(requirement.getText()));
    } else if (element instanceof LatencyConstraint constraint) {
      return new Label(named(constraint.getName(), constraint), bound(constraint));
    } else if (element instanceof Processor processor) {
      return new Label(named(processor.getName(), processor), "");
    } else if (element instanceof QosProfile qos) {
      return new Label("Quality of service", text(qos.getName()));
    }
    return element instanceof EObject object ? measured(object) : new Label("", "");
  }

  private static Label measured(EObject element) {
    if (element instanceof NodeMeasurement node) {
      return new Label("Measured", node.getActivations() + " activations");
    } else if (element instanceof ChainMeasurement chain) {
      return new Label(named(chain.getScenario(), chain), chain.isPassed() ? "passed" : "failed");
    } else if (element instanceof LatencyMeasurement latency) {
      String name = latency.getConstraint() == null ? "" : latency.getConstraint().getName();
      return new Label(named(name, latency), "");
    } else if (element instanceof LatencyPart part) {
      return new Label(
          part.getNode() == null ? "Component" : of(part.getNode()).name(),
          "waits %s ms, executes %s ms"
              .formatted(number(part.getWaiting()), number(part.getExecution())));
    } else if (element instanceof Measurement measurement) {
      return new Label(
          named(measurement.getName(), measurement),
          number(measurement.getValue()) + " " + text(measurement.getUnit()));
    } else if (element instanceof Statistics statistics) {
      return new Label(
          Words.of(statistics.eContainmentFeature()),
          "%s to %s ms"
              .formatted(number(statistics.getMinimum()), number(statistics.getMaximum())));
    }
    return new Label(Words.of(element.eClass()), "");
  }

  private static String signal(Data data) {
    String field = data.getFieldName() == null ? "" : "." + data.getFieldName();
    String topic = data.getTopicName() == null ? "" : data.getTopicName() + "  ";
    return (topic + text(data.getMessageType()) + field).strip();
  }

  private static String bound(LatencyConstraint constraint) {
    String kind = constraint.getKind().getName().toLowerCase(Locale.ROOT).replace('_', ' ');
    return constraint.isSetMaximum()
        ? kind + " \u2264 " + number(constraint.getMaximum()) + " ms"
        : kind;
  }

  /** Returns the name, or the kind of an element without one. */
  private static String named(String name, EObject element) {
    return name == null || name.isEmpty()
        ? "(" + Words.of(element.eClass()).toLowerCase(Locale.ROOT) + " without name)"
        : name;
  }

  private static String text(String value) {
    return value == null ? "" : value.replaceAll("\\s+", " ");
  }

  /** Returns a number in readable form: 20, not 20.0. */
  public static String number(double value) {
    String text = String.valueOf(value);
    return text.endsWith(".0") ? text.substring(0, text.length() - 2) : text;
  }
}
