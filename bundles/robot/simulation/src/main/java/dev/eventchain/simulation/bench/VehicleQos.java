package dev.eventchain.simulation.bench;

import dev.eventchain.messages.QosSettings;
import dev.eventchain.messages.QosSettings.Durability;
import dev.eventchain.messages.QosSettings.Liveliness;
import dev.eventchain.messages.QosSettings.Reliability;

/**
 * QoS of the vehicle with policies that DDS knows. {@code SYSTEM_DEFAULT} is the default of DDS,
 * and {@code BEST_AVAILABLE} suits every peer.
 */
final class VehicleQos {

  private VehicleQos() {}

  /** Returns the QoS of a writer. */
  static QosSettings offered(QosSettings stated) {
    Durability durability =
        switch (stated.durability()) {
          case VOLATILE, SYSTEM_DEFAULT -> Durability.VOLATILE;
          case TRANSIENT_LOCAL, BEST_AVAILABLE -> Durability.TRANSIENT_LOCAL;
        };
    boolean isManual = stated.liveliness() != Liveliness.AUTOMATIC;
    return stated
        .withReliability(
            stated.reliability() == Reliability.BEST_EFFORT
                ? Reliability.BEST_EFFORT
                : Reliability.RELIABLE)
        .withDurability(durability)
        .withLiveliness(isManual ? Liveliness.MANUAL_BY_TOPIC : Liveliness.AUTOMATIC);
  }

  /** Returns the QoS of a reader. */
  static QosSettings requested(QosSettings stated) {
    boolean isReliable = stated.reliability() == Reliability.RELIABLE;
    boolean isTransient = stated.durability() == Durability.TRANSIENT_LOCAL;
    boolean isManual = stated.liveliness() == Liveliness.MANUAL_BY_TOPIC;
    return stated
        .withReliability(isReliable ? Reliability.RELIABLE : Reliability.BEST_EFFORT)
        .withDurability(isTransient ? Durability.TRANSIENT_LOCAL : Durability.VOLATILE)
        .withLiveliness(isManual ? Liveliness.MANUAL_BY_TOPIC : Liveliness.AUTOMATIC);
  }
}
