package dev.eventchain.analysis;

import dev.eventchain.messages.QosSettings;
import dev.eventchain.messages.QosSettings.Durability;
import dev.eventchain.messages.QosSettings.History;
import dev.eventchain.messages.QosSettings.Liveliness;
import dev.eventchain.messages.QosSettings.Reliability;
import dev.eventchain.metamodel.eventchain.QosProfile;
import java.time.Duration;
import java.util.Locale;

/** What a profile of the model comes to. */
final class Qos {

  /** Longer times are none, as for the generated nodes. */
  private static final double LONGEST_MS = 1e9;

  private Qos() {}

  /** The named profile, with what is set beside the name; the default one where there is none. */
  static QosSettings settings(QosProfile profile) {
    if (profile == null) {
      return QosSettings.defaults();
    }
    String name = profile.getName() == null ? "" : profile.getName().toLowerCase(Locale.ROOT);
    QosSettings settings = QosSettings.named(name).orElseGet(QosSettings::defaults);
    if (profile.isSetReliability()) {
      settings = settings.withReliability(Reliability.valueOf(profile.getReliability().getName()));
    }
    if (profile.isSetDurability()) {
      settings = settings.withDurability(Durability.valueOf(profile.getDurability().getName()));
    }
    if (profile.isSetHistory()) {
      settings = settings.withHistory(History.valueOf(profile.getHistory().getName()));
    }
    if (profile.isSetLiveliness()) {
      settings = settings.withLiveliness(Liveliness.valueOf(profile.getLiveliness().getName()));
    }
    if (profile.isSetDepth()) {
      settings = settings.withDepth(profile.getDepth());
    }
    boolean timed =
        profile.isSetDeadline() && profile.getDeadline() > 0 && profile.getDeadline() < LONGEST_MS;
    return timed
        ? settings.withDeadline(Duration.ofNanos(Math.round(profile.getDeadline() * 1e6)))
        : settings;
  }

  /** How people find a profile again: "profile sensor_data". */
  static String words(QosProfile profile) {
    if (profile == null) {
      return "has the default profile, as it states none";
    }
    String name = profile.getName();
    return name == null || name.isEmpty()
        ? "states its policies without a profile"
        : "has the profile " + name;
  }
}
