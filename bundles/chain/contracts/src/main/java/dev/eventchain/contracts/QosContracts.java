package dev.eventchain.contracts;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.ModelChange;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.messages.QosSettings;
import dev.eventchain.messages.QosSettings.Incompatibility;
import dev.eventchain.model.QosProfiles;
import dev.eventchain.model.Signal;
import dev.eventchain.model.eventchain.Data;
import dev.eventchain.model.eventchain.EventchainPackage.Literals;
import dev.eventchain.model.eventchain.QosProfile;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;
import org.eclipse.emf.ecore.EEnum;
import org.eclipse.emf.ecore.EStructuralFeature;

/**
 * Checks that offered QoS satisfies requested QoS (OMG DDS 1.4, 2.2.3). Otherwise the middleware
 * silently does not match publisher and subscription.
 */
final class QosContracts {

  private static final String VEHICLE = "the vehicle";

  /**
   * One side of a topic.
   *
   * @param profile the stated profile; null if there is none, so that the default of ROS 2 applies
   */
  private record Side(String name, QosProfile profile, Supplier<SourceLocation> place) {

    boolean isVehicle() {
      return name.equals(VEHICLE);
    }
  }

  private final Findings findings;

  QosContracts(Findings findings) {
    this.findings = findings;
  }

  void check(Topic topic) {
    topic.endpoints().forEach(endpoint -> oneProfile(topic, endpoint));
    List<Side> requests = sides(topic.subscribers(), topic, Signal.Direction.CONSUMED);
    for (Side offer : sides(topic.publishers(), topic, Signal.Direction.PROVIDED)) {
      for (Side request : requests) {
        if (!offer.isVehicle() || !request.isVehicle()) {
          findings.checked(ContractRule.QOS_INCOMPATIBLE);
          findings.checked(ContractRule.QOS_UNDECIDED);
          compare(topic.name(), offer, request);
        }
      }
    }
  }

  /**
   * Checks that an endpoint has one profile, because a component has one publisher or subscription
   * for a topic.
   */
  private void oneProfile(Topic topic, Endpoint endpoint) {
    Data holder = endpoint.holderOfQos();
    if (holder.getQos() == null) {
      return;
    }
    for (Data data : endpoint.data()) {
      if (data.getQos() != null && data != holder) {
        findings.checked(ContractRule.QOS_AMBIGUOUS);
        if (!QosProfiles.settings(data.getQos()).equals(QosProfiles.settings(holder.getQos()))) {
          findings.warning(
              ContractRule.QOS_AMBIGUOUS,
              findings.at(data, Literals.DATA__QOS),
              "%s states two different qualities of service for %s."
                  .formatted(endpoint.name(), topic.name()),
              "A topic has one message for all its fields, and its first profile applies:"
                  + " state the same here.",
              findings.at(holder, Literals.DATA__QOS));
        }
      }
    }
  }

  private List<Side> sides(List<Endpoint> endpoints, Topic topic, Signal.Direction vehicle) {
    List<Side> sides = new ArrayList<>();
    for (Endpoint endpoint : endpoints) {
      Data holder = endpoint.holderOfQos();
      sides.add(
          new Side(
              endpoint.name(), holder.getQos(), () -> findings.at(holder, Literals.DATA__QOS)));
    }
    topic
        .signal()
        .filter(signal -> signal.direction() == vehicle)
        .map(signal -> new Side(VEHICLE, signal.qos().orElse(null), signal::location))
        .ifPresent(sides::add);
    return sides;
  }

  private void compare(String topic, Side offer, Side request) {
    QosSettings offered = QosProfiles.settings(offer.profile());
    QosSettings requested = QosProfiles.settings(request.profile());
    for (Incompatibility gap : QosSettings.incompatibilities(offered, requested)) {
      // The finding is at the chain, because the vehicle cannot be changed.
      SourceLocation here = (request.isVehicle() ? offer : request).place().get();
      SourceLocation there = (request.isVehicle() ? request : offer).place().get();
      if (gap.decided()) {
        findings.add(
            Diagnostic.of(
                    ContractRule.QOS_INCOMPATIBLE.rule(), refusal(topic, offer, request, gap), here)
                .withHint(hint(offer, request, gap))
                .withRelated(there)
                .withChanges(changes(offer, request, gap)));
      } else {
        findings.info(
            ContractRule.QOS_UNDECIDED,
            here,
            doubt(topic, offer, request, gap),
            "State the policy on both sides, so that it does not depend on the middleware's"
                + " configuration or on who starts first.",
            there);
      }
    }
  }

  private static String refusal(String topic, Side offer, Side request, Incompatibility gap) {
    return "%s requests %s %s on %s, but %s offers %s, so that no message arrives."
        .formatted(
            sentenceStart(request.name()),
            gap.policy(),
            gap.requested(),
            topic,
            offer.name(),
            gap.offered());
  }

  private static String doubt(String topic, Side offer, Side request, Incompatibility gap) {
    return "Whether messages of %s on %s reach %s depends on the %s: %s is offered, %s requested."
        .formatted(
            offer.name(), topic, request.name(), gap.policy(), gap.offered(), gap.requested());
  }

  private static String hint(Side offer, Side request, Incompatibility gap) {
    String lower = lower(request, gap);
    String raise = raise(offer, gap);
    String change;
    if (request.isVehicle()) {
      change = raise;
    } else {
      change = offer.isVehicle() ? lower : lower + ", or " + raise;
    }
    return "%s %s, %s %s: %s%s."
        .formatted(
            sentenceStart(request.name()),
            words(request.profile()),
            offer.name(),
            words(offer.profile()),
            change,
            unlessStated(offer, request));
  }

  private static String lower(Side request, Incompatibility gap) {
    return "request %s in %s".formatted(least(gap), request.name());
  }

  private static String raise(Side offer, Incompatibility gap) {
    return "offer %s in %s".formatted(most(gap), offer.name());
  }

  /** Returns the changes of policies that the hint names; times are for people to choose. */
  private static List<ModelChange> changes(Side offer, Side request, Incompatibility gap) {
    EStructuralFeature policy = Literals.QOS_PROFILE.getEStructuralFeature(gap.policy());
    if (policy == null || !(policy.getEType() instanceof EEnum)) {
      return List.of();
    }
    boolean certain = offer.isVehicle() || request.isVehicle();
    List<ModelChange> changes = new ArrayList<>();
    if (!request.isVehicle()) {
      changes.add(change(lower(request, gap), request, policy, gap.offered(), certain));
    }
    if (!offer.isVehicle()) {
      changes.add(change(raise(offer, gap), offer, policy, gap.requested(), certain));
    }
    return changes;
  }

  private static ModelChange change(
      String words, Side side, EStructuralFeature policy, String to, boolean certain) {
    String child = Literals.DATA__QOS.getName();
    SourceLocation place = side.place().get();
    return new ModelChange(sentenceStart(words), place, child, policy.getName(), "", to, certain);
  }

  /** Returns the profile in words: "has the profile sensor_data". */
  private static String words(QosProfile profile) {
    if (profile == null) {
      return "has the default profile, as it states none";
    }
    String name = profile.getName();
    return name == null || name.isEmpty()
        ? "states its policies without a profile"
        : "has the profile " + name;
  }

  /** Returns the end of a hint: for users, the missing profile of a signal. */
  private static String unlessStated(Side offer, Side request) {
    Side vehicle = request.isVehicle() ? request : offer;
    Side component = request.isVehicle() ? offer : request;
    boolean isUnstated = vehicle.isVehicle() && vehicle.profile() == null;
    return isUnstated && !component.place().get().file().endsWith(".json")
        ? "; if the vehicle %s otherwise, state its qos_profile in signals.json"
            .formatted(request.isVehicle() ? "reads it" : "sends it")
        : "";
  }

  /** Returns the requests that the offer satisfies. Longer times are weaker. */
  private static String least(Incompatibility gap) {
    if (gap.offered().equals(QosSettings.NO_TIME)) {
      return "no " + gap.policy();
    }
    String what = gap.policy() + " " + gap.offered();
    return gap.offered().endsWith(" ms") ? what + " or longer" : what;
  }

  /** Returns the offers that satisfy the request. */
  private static String most(Incompatibility gap) {
    String what = gap.policy() + " " + gap.requested();
    return gap.requested().endsWith(" ms") ? what + " or shorter" : what;
  }

  private static String sentenceStart(String name) {
    return Character.toUpperCase(name.charAt(0)) + name.substring(1);
  }
}
