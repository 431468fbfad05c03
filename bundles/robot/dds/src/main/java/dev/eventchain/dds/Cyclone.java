package dev.eventchain.dds;

import com.sun.jna.FunctionMapper;
import com.sun.jna.Library;
import com.sun.jna.NativeLibrary;
import com.sun.jna.Pointer;
import com.sun.jna.ptr.LongByReference;
import com.sun.jna.ptr.PointerByReference;
import java.lang.reflect.Method;
import java.util.Locale;

/**
 * The functions of libddsc 11 (dds/dds.h, dds/ddsc/dds_public_dynamic_type.h) that are called
 * rarely; those called for each sample are in {@link Samples}. Names are those of C in camel case,
 * without {@code dds_}. The library checks handles, but not pointers.
 */
interface Cyclone extends Library {

  /** Maps Java names to C names: {@code createTopic} is {@code dds_create_topic}. */
  FunctionMapper NAMES = Cyclone::nameOf;

  private static String nameOf(NativeLibrary library, Method method) {
    String name = method.getName().replaceAll("([A-Z])", "_$1").toLowerCase(Locale.ROOT);
    return name.startsWith("ddsi_") ? name : "dds_" + name;
  }

  int createDomain(int id, String configuration);

  int createParticipant(int domain, Pointer qos, Pointer listener);

  int createTopic(int participant, Pointer descriptor, String name, Pointer qos, Pointer listener);

  int createWriter(int participant, int topic, Pointer qos, Pointer listener);

  int createReader(int participant, int topic, Pointer qos, Pointer listener);

  int createReadcondition(int reader, int mask);

  int createGuardcondition(int owner);

  int setGuardcondition(int guard, boolean triggered);

  int createWaitset(int owner);

  int waitsetAttach(int waitset, int entity, long tag);

  int delete(int entity);

  int getGuid(int entity, byte[] guid);

  int getEntitySertype(int entity, PointerByReference type);

  int getMatchedSubscriptions(int writer, Pointer handles, long count);

  int getMatchedPublications(int reader, Pointer handles, long count);

  Pointer getMatchedSubscriptionData(int writer, long handle);

  Pointer getMatchedPublicationData(int reader, long handle);

  void builtintopicFreeEndpoint(Pointer endpoint);

  int getOfferedIncompatibleQosStatus(int writer, Pointer status);

  int getRequestedIncompatibleQosStatus(int reader, Pointer status);

  int getOfferedDeadlineMissedStatus(int writer, Pointer status);

  int getRequestedDeadlineMissedStatus(int reader, Pointer status);

  int getLivelinessLostStatus(int writer, Pointer status);

  int getLivelinessChangedStatus(int reader, Pointer status);

  int getSampleLostStatus(int reader, Pointer status);

  int assertLiveliness(int entity);

  int readMask(int reader, Pointer samples, Pointer information, long size, int most, int mask);

  int returnLoan(int reader, Pointer samples, int count);

  void free(Pointer memory);

  Pointer createQos();

  void deleteQos(Pointer qos);

  void qsetReliability(Pointer qos, int kind, long maximalBlockingTime);

  void qsetDurability(Pointer qos, int kind);

  void qsetDurabilityService(
      Pointer qos, long cleanup, int history, int depth, int samples, int instances, int each);

  void qsetHistory(Pointer qos, int kind, int depth);

  void qsetDeadline(Pointer qos, long period);

  void qsetLiveliness(Pointer qos, int kind, long lease);

  void qsetDataRepresentation(Pointer qos, int count, short[] representations);

  void qsetWriterDataLifecycle(Pointer qos, boolean autodispose);

  void qsetUserdata(Pointer qos, byte[] data, long size);

  // A Boolean of C is a byte; the other bytes of the register are undefined.

  byte qgetReliability(Pointer qos, int[] kind, long[] maximalBlockingTime);

  byte qgetDurability(Pointer qos, int[] kind);

  byte qgetDeadline(Pointer qos, long[] period);

  byte qgetLiveliness(Pointer qos, int[] kind, long[] lease);

  byte qgetUserdata(Pointer qos, PointerByReference data, LongByReference size);

  DynamicTypes.Type.ByValue dynamicTypeCreate(
      int entity, DynamicTypes.Descriptor.ByValue descriptor);

  int dynamicTypeAddMember(DynamicTypes.Type type, DynamicTypes.Member.ByValue member);

  int dynamicTypeSetExtensibility(DynamicTypes.Type type, int extensibility);

  int dynamicTypeSetNested(DynamicTypes.Type type, boolean nested);

  int dynamicTypeRegister(DynamicTypes.Type type, PointerByReference information);

  int dynamicTypeUnref(DynamicTypes.Type type);

  int freeTypeinfo(Pointer information);

  int createTopicDescriptor(
      int scope, int participant, Pointer information, long timeout, PointerByReference result);

  void deleteTopicDescriptor(Pointer descriptor);

  Pointer strretcode(int code);
}
