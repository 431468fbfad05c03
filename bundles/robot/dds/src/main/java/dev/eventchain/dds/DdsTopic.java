package dev.eventchain.dds;

import com.sun.jna.Memory;
import com.sun.jna.Pointer;
import dev.eventchain.messages.MessageType;
import dev.eventchain.messages.QosSettings;
import java.util.HashSet;
import java.util.Set;

/**
 * A topic in the library, and what its writers and readers ask the library.
 *
 * @param ddsName the name in DDS
 * @param name the name in messages to the user
 */
record DdsTopic(Cyclone cyclone, String ddsName, String name, MessageType type) {

  private static final int GUID_SIZE = 16;

  /** Creates an entity of the library. */
  @FunctionalInterface
  interface Creation {
    /** Returns a handle, or a negative return code. */
    int create(int participant, int topic, Pointer qos, Pointer listener);
  }

  int create(DdsParticipant participant, QosSettings settings, Side side) {
    int topicHandle = participant.topic(ddsName, type);
    Creation creation = side == Side.WRITER ? cyclone::createWriter : cyclone::createReader;
    return Policies.with(
        cyclone,
        settings,
        side,
        "typehash=" + type.hash() + ";",
        qos ->
            check(
                creation.create(participant.handle(), topicHandle, qos, null),
                "create a " + side.word()));
  }

  int check(int result, String what) {
    return Codes.check(cyclone, result, what + " of " + name);
  }

  byte[] gid(int handle) {
    byte[] gid = new byte[GUID_SIZE];
    check(cyclone.getGuid(handle, gid), "name an endpoint");
    return gid;
  }

  /** Returns the GUIDs of the endpoints that match one, as hexadecimal digits. */
  Set<String> peers(int handle, Side side) {
    int room = matched(handle, side, null, 0) + 8;
    Memory handles = new Memory((long) room * Long.BYTES);
    int count = Math.min(room, matched(handle, side, handles, room));
    Set<String> peers = new HashSet<>();
    for (int i = 0; i < count; i++) {
      long peer = handles.getLong((long) i * Long.BYTES);
      Pointer found =
          side == Side.WRITER
              ? cyclone.getMatchedSubscriptionData(handle, peer)
              : cyclone.getMatchedPublicationData(handle, peer);
      if (found != null) { // else it was deleted meanwhile
        peers.add(DdsEndpoint.hex(found.getByteArray(0, GUID_SIZE)));
        cyclone.builtintopicFreeEndpoint(found);
      }
    }
    return peers;
  }

  /** Returns the number of endpoints that match one, and writes their handles. */
  int matched(int handle, Side side, Pointer handles, int room) {
    return side == Side.WRITER
        ? check(cyclone.getMatchedSubscriptions(handle, handles, room), "count the readers")
        : check(cyclone.getMatchedPublications(handle, handles, room), "count the writers");
  }
}
