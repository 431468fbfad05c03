package dev.eventchain.dds;

import com.eprosima.xmlschemas.fastrtps_profiles.DurabilityQosKindPolicyType;
import com.eprosima.xmlschemas.fastrtps_profiles.HistoryQosKindPolicyType;
import com.eprosima.xmlschemas.fastrtps_profiles.ReliabilityQosKindPolicyType;
import java.io.IOException;
import java.net.InetAddress;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.function.BiConsumer;
import us.ihmc.idl.CDR;
import us.ihmc.idl.InterchangeSerializer;
import us.ihmc.pubsub.Domain;
import us.ihmc.pubsub.DomainFactory;
import us.ihmc.pubsub.TopicDataType;
import us.ihmc.pubsub.attributes.ParticipantProfile;
import us.ihmc.pubsub.attributes.PublisherAttributes;
import us.ihmc.pubsub.attributes.SubscriberAttributes;
import us.ihmc.pubsub.common.LogLevel;
import us.ihmc.pubsub.common.MatchingInfo;
import us.ihmc.pubsub.common.SampleInfo;
import us.ihmc.pubsub.common.SerializedPayload;
import us.ihmc.pubsub.common.Time;
import us.ihmc.pubsub.participant.Participant;
import us.ihmc.pubsub.publisher.Publisher;
import us.ihmc.pubsub.subscriber.Subscriber;
import us.ihmc.pubsub.subscriber.SubscriberListener;

/** A participant of Fast DDS in this process, with its own codecs for two message types. */
final class FastDds implements AutoCloseable {

  /** A std_msgs/msg/Float32. */
  static final class Value {
    float data;
  }

  /** A sensor_msgs/msg/LaserScan. */
  static final class Scan {
    int sec;
    int nanosec;
    String frameId = "";
    final float[] settings = new float[7];
    float[] ranges = {};
    float[] intensities = {};
  }

  private final Domain domain = DomainFactory.getDefaultDomain();
  private final Participant participant;
  private final Set<String> registered = new HashSet<>();

  FastDds(int domainId) throws IOException {
    domain.setLogLevel(LogLevel.ERROR);
    ParticipantProfile profile =
        ParticipantProfile.create()
            .domainId(domainId)
            .name("fast_dds")
            .bindToAddressRestrictions(false, List.of(InetAddress.getLoopbackAddress()));
    participant = domain.createParticipant(profile);
  }

  private void register(TopicDataType<?> type) throws IOException {
    if (registered.add(type.getName())) {
      domain.registerType(participant, type);
    }
  }

  Publisher publisher(String topic, TopicDataType<?> type) throws IOException {
    register(type);
    return domain.createPublisher(
        participant,
        PublisherAttributes.create()
            .topicDataType(type)
            .topicName(topic)
            .reliabilityKind(ReliabilityQosKindPolicyType.RELIABLE)
            .durabilityKind(DurabilityQosKindPolicyType.VOLATILE)
            .historyQosPolicyKind(HistoryQosKindPolicyType.KEEP_LAST)
            .historyDepth(10));
  }

  /**
   * Passes on received samples with their source timestamp in ns; this binding drops whole seconds.
   */
  <T> void subscribe(String topic, TopicDataType<T> type, BiConsumer<T, Long> listener)
      throws IOException {
    register(type);
    Subscriber<?> unused =
        domain.createSubscriber(
            participant,
            SubscriberAttributes.create()
                .topicDataType(type)
                .topicName(topic)
                .reliabilityKind(ReliabilityQosKindPolicyType.RELIABLE)
                .durabilityKind(DurabilityQosKindPolicyType.VOLATILE)
                .historyQosPolicyKind(HistoryQosKindPolicyType.KEEP_LAST)
                .historyDepth(10),
            new Listener<T>(type, listener));
  }

  private record Listener<T>(TopicDataType<T> type, BiConsumer<T, Long> next)
      implements SubscriberListener<T> {
    @Override
    public void onNewDataMessage(Subscriber<T> subscriber) {
      T data = type.createData();
      SampleInfo information = new SampleInfo();
      if (subscriber.takeNextData(data, information)) {
        Time time = information.getSourceTimestamp();
        next.accept(data, time.getNanoseconds());
      }
    }

    @Override
    public void onSubscriptionMatched(Subscriber<T> subscriber, MatchingInfo information) {}
  }

  @Override
  public void close() {
    domain.removeParticipant(participant);
  }

  /** Common part of both types. */
  private abstract static class Type<T> implements TopicDataType<T> {
    private final CDR serializer = new CDR();
    private final CDR deserializer = new CDR();

    @Override
    public final void serialize(T data, SerializedPayload payload) {
      serializer.serialize(payload);
      serialize(data, serializer);
      serializer.finishSerialize();
    }

    @Override
    public final void deserialize(SerializedPayload payload, T data) {
      deserializer.deserialize(payload);
      deserialize(data, deserializer);
      deserializer.finishDeserialize();
    }

    @Override
    public final void serialize(T data, InterchangeSerializer unused) {
      throw new UnsupportedOperationException();
    }

    @Override
    public final void deserialize(InterchangeSerializer unused, T data) {
      throw new UnsupportedOperationException();
    }

    @Override
    public final void copy(T from, T to) {
      throw new UnsupportedOperationException();
    }

    @Override
    public final int getTypeSize() {
      return 10_000;
    }
  }

  /** Writes and reads {@link Value}. */
  static final class NumberType extends Type<Value> {
    @Override
    public void serialize(Value number, CDR cdr) {
      cdr.write_type_5(number.data);
    }

    @Override
    public void deserialize(Value number, CDR cdr) {
      number.data = cdr.read_type_5();
    }

    @Override
    public String getName() {
      return "std_msgs::msg::dds_::Float32_";
    }

    @Override
    public Value createData() {
      return new Value();
    }

    @Override
    public TopicDataType<Value> newInstance() {
      return new NumberType();
    }
  }

  /** Writes and reads {@link Scan}. */
  static final class ScanType extends Type<Scan> {
    @Override
    public void serialize(Scan scan, CDR cdr) {
      cdr.write_type_2(scan.sec);
      cdr.write_type_4(scan.nanosec);
      cdr.write_type_d(new StringBuilder(scan.frameId));
      for (float setting : scan.settings) {
        cdr.write_type_5(setting);
      }
      write(scan.ranges, cdr);
      write(scan.intensities, cdr);
    }

    private static void write(float[] values, CDR cdr) {
      cdr.write_type_2(values.length);
      for (float value : values) {
        cdr.write_type_5(value);
      }
    }

    @Override
    public void deserialize(Scan scan, CDR cdr) {
      scan.sec = cdr.read_type_2();
      scan.nanosec = (int) cdr.read_type_4();
      StringBuilder text = new StringBuilder();
      cdr.read_type_d(text);
      scan.frameId = text.toString();
      for (int i = 0; i < scan.settings.length; i++) {
        scan.settings[i] = cdr.read_type_5();
      }
      scan.ranges = read(cdr);
      scan.intensities = read(cdr);
    }

    private static float[] read(CDR cdr) {
      float[] values = new float[cdr.read_type_2()];
      for (int i = 0; i < values.length; i++) {
        values[i] = cdr.read_type_5();
      }
      return values;
    }

    @Override
    public String getName() {
      return "sensor_msgs::msg::dds_::LaserScan_";
    }

    @Override
    public Scan createData() {
      return new Scan();
    }

    @Override
    public TopicDataType<Scan> newInstance() {
      return new ScanType();
    }
  }
}
