package dev.eventchain.description;

import dev.eventchain.model.eventchain.EventchainPackage.Literals;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import org.eclipse.emf.ecore.EStructuralFeature;

/**
 * Names in event-chain descriptions, {@code chain.json}: the only table of them for the reader, the
 * writer, the schema and the checks of answers.
 */
public final class ChainNames {

  /** The components in the object around the array of the paper. */
  public static final String COMPONENTS = "components";

  /** Of components and values. */
  public static final String NAME = "name";

  /** Of components and values. */
  public static final String DESCRIPTION = "description";

  /** Of a component, in Hz. */
  public static final String FREQUENCY = "frequency";

  /** Of a component, in ms. */
  public static final String BEST_CASE_EXECUTION_TIME = "best_case_execution_time";

  /** Of a component, in ms. */
  public static final String WORST_CASE_EXECUTION_TIME = "worst_case_execution_time";

  /** Of a component, in MiB. */
  public static final String MEMORY = "memory";

  /** Of a component: the topics of the inputs that belong together. */
  public static final String SYNCHRONIZED = "synchronized";

  /** Of a component with synchronized inputs, in ms. */
  public static final String TOLERANCE = "tolerance";

  /** Of a component: the name of what executes it. */
  public static final String PROCESSOR = "processor";

  /** Of a component on a processor; larger numbers go first. */
  public static final String PRIORITY = "priority";

  /** Of a component of a software base: {@code component} or {@code node}. */
  public static final String IMPLEMENTATION = "implementation";

  /** Of a component of a software base: its Python file. */
  public static final String FILE = "file";

  /** Of a component of a software base that is a node: its class, and how it is launched. */
  public static final String NODE = "node";

  /** The ids of components and outputs. */
  public static final String REQUIREMENTS = "requirements";

  /** The ports that a component reads. */
  public static final String INPUT = "input";

  /** The ports that a component writes. */
  public static final String OUTPUT = "output";

  /** Of a port. */
  public static final String TOPIC = "topic";

  /** Of a port. */
  public static final String MESSAGE_TYPE = "message_type";

  /** Of a port: a profile's name, a depth or an object with policies. */
  public static final String QOS_PROFILE = "qos_profile";

  /** Of an output that leaves the chain: {@link #EXTERNAL}. */
  public static final String CONSUMER = "consumer";

  /** The only consumer that is not a component. */
  public static final String EXTERNAL = "external";

  /** Of a port, in ms: the longest time of a message on its way. */
  public static final String WORST_CASE_TRANSPORT_TIME = "worst_case_transport_time";

  /** The values of a port. */
  public static final String VALUES = "values";

  /** The path of a value's field in its message. */
  public static final String FIELD = "field";

  /** Of a value. */
  public static final String TYPE = "type";

  /** Of a value. */
  public static final String UNIT = "unit";

  /** Of a value whose unit in the component is not that of the message. */
  public static final String COMPONENT_UNIT = "component_unit";

  /** Of an input's value, in ms. */
  public static final String MAXIMUM_AGE = "maximum_age";

  /** Of an output's value. */
  public static final String SAFE_VALUE = "safe_value";

  /** The profile of ROS 2 that the policies change. */
  public static final String PROFILE = "profile";

  /** A policy. */
  public static final String RELIABILITY = "reliability";

  /** A policy. */
  public static final String DURABILITY = "durability";

  /** A policy. */
  public static final String HISTORY = "history";

  /** A policy. */
  public static final String DEPTH = "depth";

  /** A policy, in ms. */
  public static final String DEADLINE = "deadline";

  /** A policy. */
  public static final String LIVELINESS = "liveliness";

  /** A policy, in ms. */
  public static final String LEASE_DURATION = "lease_duration";

  private static final Map<EStructuralFeature, String> BY_FEATURE = new HashMap<>();

  static {
    BY_FEATURE.put(Literals.SOFTWARE_NODE__NAME, NAME);
    BY_FEATURE.put(Literals.SOFTWARE_NODE__FREQUENCY, FREQUENCY);
    BY_FEATURE.put(Literals.SOFTWARE_NODE__BEST_CASE_EXECUTION_TIME, BEST_CASE_EXECUTION_TIME);
    BY_FEATURE.put(Literals.SOFTWARE_NODE__WORST_CASE_EXECUTION_TIME, WORST_CASE_EXECUTION_TIME);
    BY_FEATURE.put(Literals.SOFTWARE_NODE__MEMORY, MEMORY);
    BY_FEATURE.put(Literals.SOFTWARE_NODE__INPUT, INPUT);
    BY_FEATURE.put(Literals.SOFTWARE_NODE__OUTPUT, OUTPUT);
    BY_FEATURE.put(Literals.SOFTWARE_NODE__SYNCHRONIZED, SYNCHRONIZED);
    BY_FEATURE.put(Literals.SOFTWARE_NODE__TOLERANCE, TOLERANCE);
    BY_FEATURE.put(Literals.SOFTWARE_NODE__MAPPED_TO, PROCESSOR);
    BY_FEATURE.put(Literals.SOFTWARE_NODE__PRIORITY, PRIORITY);
    BY_FEATURE.put(Literals.DATA__NAME, NAME);
    BY_FEATURE.put(Literals.DATA__FIELD_NAME, FIELD);
    BY_FEATURE.put(Literals.DATA__TYPE, TYPE);
    BY_FEATURE.put(Literals.DATA__UNIT, UNIT);
    BY_FEATURE.put(Literals.DATA__COMPONENT_UNIT, COMPONENT_UNIT);
    BY_FEATURE.put(Literals.DATA__MAXIMUM_AGE, MAXIMUM_AGE);
    BY_FEATURE.put(Literals.DATA__SAFE_VALUE, SAFE_VALUE);
    BY_FEATURE.put(Literals.DATA__TOPIC_NAME, TOPIC);
    BY_FEATURE.put(Literals.DATA__MESSAGE_TYPE, MESSAGE_TYPE);
    BY_FEATURE.put(Literals.DATA__QOS, QOS_PROFILE);
    BY_FEATURE.put(Literals.DATA__WORST_CASE_TRANSPORT_TIME, WORST_CASE_TRANSPORT_TIME);
    BY_FEATURE.put(Literals.QOS_PROFILE__NAME, PROFILE);
    BY_FEATURE.put(Literals.QOS_PROFILE__RELIABILITY, RELIABILITY);
    BY_FEATURE.put(Literals.QOS_PROFILE__DURABILITY, DURABILITY);
    BY_FEATURE.put(Literals.QOS_PROFILE__HISTORY, HISTORY);
    BY_FEATURE.put(Literals.QOS_PROFILE__DEPTH, DEPTH);
    BY_FEATURE.put(Literals.QOS_PROFILE__DEADLINE, DEADLINE);
    BY_FEATURE.put(Literals.QOS_PROFILE__LIVELINESS, LIVELINESS);
    BY_FEATURE.put(Literals.QOS_PROFILE__LEASE_DURATION, LEASE_DURATION);
  }

  private ChainNames() {}

  /** Returns the name of the property that a finding about a feature points to; empty if none. */
  static Optional<String> of(EStructuralFeature feature) {
    return Optional.ofNullable(BY_FEATURE.get(feature));
  }

  /** Returns the rule for values of a property, for people; empty if there is none. */
  static String ruleOf(String property) {
    return switch (property) {
      case TOPIC ->
          "Topics are names separated by slashes, without two underscores in a row:"
              + " /carla/ego_vehicle/lidar.";
      case MESSAGE_TYPE -> "Write it with its package: sensor_msgs/msg/LaserScan.";
      case FIELD -> "Fields are names separated by dots: header.stamp.sec.";
      default -> "";
    };
  }
}
