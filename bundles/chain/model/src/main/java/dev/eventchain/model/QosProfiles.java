package dev.eventchain.model;

import dev.eventchain.messages.QosSettings;
import dev.eventchain.messages.QosSettings.Durability;
import dev.eventchain.messages.QosSettings.History;
import dev.eventchain.messages.QosSettings.Liveliness;
import dev.eventchain.messages.QosSettings.Reliability;
import dev.eventchain.model.eventchain.QosProfile;
import java.time.Duration;
import java.util.Locale;

/** Settings of the QoS profiles of the model. */
public final class QosProfiles {

  /** Longest time; longer ones count as unset, as in the generated nodes. */
  private static final double LONGEST_MS = 1e9;

  private QosProfiles() {}

  /**
   * Returns the settings of the named profile with its overrides; those of the default profile if
   * there is none.
   */
  public static QosSettings settings(QosProfile profile) {
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

  /** Returns whether a time is set; unset times are zero. */
  private static boolean isTime(double milliseconds) {
    return milliseconds > 0 && milliseconds < LONGEST_MS;
  }

  private static Duration duration(double milliseconds) {
    return Duration.ofNanos(Math.round(milliseconds * 1e6));
  }
}
