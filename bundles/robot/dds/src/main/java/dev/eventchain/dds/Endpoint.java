package dev.eventchain.dds;

import com.sun.jna.Pointer;
import dev.eventchain.messages.MessageType;
import dev.eventchain.messages.QosSettings;

/**
 * Common part of writers and readers.
 *
 * @param ddsTopic the name of the topic in DDS
 * @param topic the name in messages to the user
 */
record Endpoint(Cyclone cyclone, String ddsTopic, String topic, MessageType type) {

  private static final int GUID_SIZE = 16;

  /** Creates an entity of the library. */
  @FunctionalInterface
  interface Creation {
    /** Returns a handle, or a negative return code. */
    int create(int participant, int topic, Pointer qos, Pointer listener);
  }

  int create(DdsParticipant participant, QosSettings settings, boolean writer) {
    int topicHandle = participant.topic(ddsTopic, type);
    Creation creation = writer ? cyclone::createWriter : cyclone::createReader;
    return Policies.with(
        cyclone,
        settings,
        writer,
        "typehash=" + type.hash() + ";",
        qos ->
            check(
                creation.create(participant.handle(), topicHandle, qos, null),
                writer ? "create a writer" : "create a reader"));
  }

  int check(int result, String what) {
    return Codes.check(cyclone, result, what + " of " + topic);
  }

  byte[] gid(int handle) {
    byte[] gid = new byte[GUID_SIZE];
    check(cyclone.getGuid(handle, gid), "name an endpoint");
    return gid;
  }
}
