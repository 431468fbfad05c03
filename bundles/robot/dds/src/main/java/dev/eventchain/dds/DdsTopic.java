package dev.eventchain.dds;

import com.sun.jna.Memory;
import com.sun.jna.Pointer;
import dev.eventchain.messages.MessageType;
import dev.eventchain.messages.QosSettings;
import java.util.HashSet;
import java.util.HexFormat;
import java.util.Set;

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

  /** Returns the GUIDs of the endpoints that match one, as hexadecimal digits. */
  Set<String> peers(int handle, boolean writer) {
    int room = matched(handle, writer, null, 0) + 8;
    Memory handles = new Memory((long) room * Long.BYTES);
    int count = Math.min(room, matched(handle, writer, handles, room));
    Set<String> peers = new HashSet<>();
    for (int i = 0; i < count; i++) {
      long peer = handles.getLong((long) i * Long.BYTES);
      Pointer found =
          writer
              ? cyclone.getMatchedSubscriptionData(handle, peer)
              : cyclone.getMatchedPublicationData(handle, peer);
      if (found != null) { // else it was deleted meanwhile
        peers.add(hex(found.getByteArray(0, GUID_SIZE)));
        cyclone.builtintopicFreeEndpoint(found);
      }
    }
    return peers;
  }

  /** Returns the number of endpoints that match one, and writes their handles. */
  int matched(int handle, boolean writer, Pointer handles, int room) {
    return writer
        ? check(cyclone.getMatchedSubscriptions(handle, handles, room), "count the readers")
        : check(cyclone.getMatchedPublications(handle, handles, room), "count the writers");
  }

  static String hex(byte[] guid) {
    return HexFormat.of().formatHex(guid);
  }
}
