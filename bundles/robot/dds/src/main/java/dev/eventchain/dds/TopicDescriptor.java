package dev.eventchain.dds;

import com.sun.jna.Pointer;

/** {@code dds_topic_descriptor_t}: the library's description of a type, in its memory. */
final class TopicDescriptor {

  private static final long FLAGS = 8;
  private static final long KEY_COUNT = 12;
  private static final long TYPE_NAME = 16;
  private static final long INFORMATION = 56;
  private static final long INFORMATION_SIZE = 64;
  private static final long MAPPING = 72;
  private static final long MAPPING_SIZE = 80;
  private static final int HAS_TYPE_INFORMATION = 1 << 6;
  private static final int LONGEST = 1_000_000;

  private final Pointer pointer;
  private final Pointer information;
  private final Pointer mapping;
  private final int informationSize;
  private final int mappingSize;

  TopicDescriptor(Pointer pointer) {
    this.pointer = pointer;
    information = pointer.getPointer(INFORMATION);
    informationSize = pointer.getInt(INFORMATION_SIZE);
    mapping = pointer.getPointer(MAPPING);
    mappingSize = pointer.getInt(MAPPING_SIZE);
  }

  Pointer pointer() {
    return pointer;
  }

  /**
   * Removes the type information, which ROS 2 does not announce and which makes Cyclone refuse
   * other types.
   *
   * @throws IllegalStateException if this is not a description of that type
   */
  void dropTypeInformation(String typeName) {
    boolean known =
        (pointer.getInt(FLAGS) & HAS_TYPE_INFORMATION) != 0
            && pointer.getInt(KEY_COUNT) == 0
            && isSize(informationSize)
            && isSize(mappingSize)
            && pointer.getPointer(TYPE_NAME).getString(0).equals(typeName);
    if (!known) {
      throw new IllegalStateException("The library describes types in an unknown way.");
    }
    pointer.setInt(FLAGS, pointer.getInt(FLAGS) & ~HAS_TYPE_INFORMATION);
    set(null, 0, null, 0);
  }

  private static boolean isSize(int size) {
    return size > 0 && size < LONGEST;
  }

  /** Restores the type information, so that the library can free it. */
  void restore() {
    set(information, informationSize, mapping, mappingSize);
  }

  private void set(Pointer first, int firstSize, Pointer second, int secondSize) {
    pointer.setPointer(INFORMATION, first);
    pointer.setInt(INFORMATION_SIZE, firstSize);
    pointer.setPointer(MAPPING, second);
    pointer.setInt(MAPPING_SIZE, secondSize);
  }
}
