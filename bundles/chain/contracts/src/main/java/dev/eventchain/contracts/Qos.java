package dev.eventchain.contracts;

import dev.eventchain.messages.QosSettings;
import dev.eventchain.messages.QosSettings.Durability;
import dev.eventchain.messages.QosSettings.History;
import dev.eventchain.messages.QosSettings.Liveliness;
import dev.eventchain.messages.QosSettings.Reliability;
import dev.eventchain.model.eventchain.QosProfile;
import java.time.Duration;
import java.util.Locale;

/** What a profile of the model comes to. */
final class Qos {

  /** Longer times are none, as for the generated nodes. */
  private static final double LONGEST_MS = 1e9;

  private Qos() {}

  /** The named profile, with what is set next to the name; the default one where there is none. */
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
    return timed(settings, profile);
  }

  private static QosSettings timed(QosSettings untimed, QosProfile profile) {
    QosSettings settings = untimed;
    if (isTime(profile.getDeadline())) {
      settings = settings.withDeadline(duration(profile.getDeadline()));
    }
    if (isTime(profile.getLeaseDuration())) {
      settings = settings.withLease(duration(profile.getLeaseDuration()));
    }
    return settings;
  }

  /** What is not set is zero. */
  private static boolean isTime(double milliseconds) {
    return milliseconds > 0 && milliseconds < LONGEST_MS;
  }

  private static Duration duration(double milliseconds) {
    return Duration.ofNanos(Math.round(milliseconds * 1e6));
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
