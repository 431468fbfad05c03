package dev.eventchain.messages;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/** A release of ROS 2, whose packages define the standard message types. */
public enum RosDistribution {
  HUMBLE("humble", "Humble"),
  JAZZY("jazzy", "Jazzy");

  /** The release whose definitions apply where nothing names one. */
  public static final RosDistribution DEFAULT = HUMBLE;

  private final String id;
  private final String words;

  RosDistribution(String id, String words) {
    this.id = id;
    this.words = words;
  }

  /** Returns the release with an {@link #id}. */
  public static Optional<RosDistribution> of(String id) {
    return Arrays.stream(values()).filter(each -> each.id.equals(id)).findFirst();
  }

  /** Returns the ids of all releases, oldest first. */
  public static List<String> ids() {
    return Arrays.stream(values()).map(RosDistribution::id).toList();
  }

  /** Returns the name in files, as in {@code ROS_DISTRO}. */
  public String id() {
    return id;
  }

  /** Returns the name for people. */
  @Override
  public String toString() {
    return words;
  }
}
