package dev.eventchain.dds;

import com.sun.jna.Memory;
import com.sun.jna.Pointer;
import com.sun.jna.Structure;
import com.sun.jna.ptr.PointerByReference;
import dev.eventchain.messages.FieldType;
import dev.eventchain.messages.MessageType;

/** Creates topics of message types by the library's interface for types known at run time. */
final class DynamicTypes {

  /** {@code dds_dynamic_type_t}. */
  @Structure.FieldOrder({"first", "second", "result"})
  public static class Type extends Structure {
    /** A pointer of the library. */
    public Pointer first;

    /** A second pointer of the library. */
    public Pointer second;

    /** The return code of the last function. */
    public int result;

    /** The structure as passed and returned by value. */
    public static final class ByValue extends Type implements Structure.ByValue {}
  }

  /** {@code dds_dynamic_type_spec_t}: a primitive type, or a type in three words. */
  @Structure.FieldOrder({"kind", "first", "second", "third"})
  public static final class Spec extends Structure {
    /** 0 if unset, {@link #DEFINED} or {@link #PRIMITIVE}. */
    public int kind;

    /** The kind of the primitive type, or the first word of the type. */
    public long first;

    /** The second word of the type. */
    public long second;

    /** The third word of the type. */
    public long third;

    void primitive(int type) {
      kind = PRIMITIVE;
      first = type;
    }

    void defined(Type type) {
      kind = DEFINED;
      first = Pointer.nativeValue(type.first);
      second = Pointer.nativeValue(type.second);
      third = Integer.toUnsignedLong(type.result);
    }
  }

  /** {@code dds_dynamic_type_descriptor_t}. */
  @Structure.FieldOrder({
    "kind",
    "name",
    "base",
    "discriminator",
    "boundCount",
    "bounds",
    "element",
    "key"
  })
  public static class Descriptor extends Structure {
    /** The kind, such as {@link #STRUCT}. */
    public int kind;

    /** The name. */
    public String name;

    /** Unset. */
    public Spec base;

    /** Unset. */
    public Spec discriminator;

    /** The number of bounds: 0 or 1. */
    public int boundCount;

    /** The length of an array, or the maximal length of a sequence or string. */
    public Pointer bounds;

    /** The element type of an array or a sequence. */
    public Spec element;

    /** Unset. */
    public Spec key;

    /** The structure as passed by value. */
    public static final class ByValue extends Descriptor implements Structure.ByValue {}
  }

  /** {@code dds_dynamic_member_descriptor_t}. */
  @Structure.FieldOrder({
    "name",
    "id",
    "type",
    "defaultValue",
    "index",
    "labelCount",
    "labels",
    "defaultLabel"
  })
  public static class Member extends Structure {
    /** The name. */
    public String name;

    /** An explicit id: the constant for "choose one" differs between versions. */
    public int id;

    /** The type. */
    public Spec type;

    /** Unset. */
    public Pointer defaultValue;

    /** The position, {@link #AT_END}. */
    public int index;

    /** Unset. */
    public int labelCount;

    /** Unset. */
    public Pointer labels;

    /** Unset. */
    public byte defaultLabel;

    /** The structure as passed by value. */
    public static final class ByValue extends Member implements Structure.ByValue {}
  }

  private static final int DEFINED = 1;
  private static final int PRIMITIVE = 2;
  private static final int STRING8 = 16;
  private static final int ARRAY = 21;
  private static final int SEQUENCE = 22;
  private static final int STRUCT = 24;
  private static final int AT_END = -1;
  private static final int FINAL = 0;
  private static final int LOCAL_DOMAIN = 1;
  private static final long TIMEOUT = 10_000_000_000L;

  private final Cyclone cyclone;
  private final int participant;

  DynamicTypes(Cyclone cyclone, int participant) {
    this.cyclone = cyclone;
    this.participant = participant;
  }

  /**
   * Creates a topic.
   *
   * @param name the DDS name, with its prefix
   * @throws IllegalArgumentException if the participant has a topic of this name with another type
   */
  int topic(String name, MessageType type) {
    Type root = structure(type, false);
    PointerByReference information = new PointerByReference();
    PointerByReference descriptor = new PointerByReference();
    try {
      check(cyclone.dynamicTypeRegister(root, information), "type", type.name());
      check(
          cyclone.createTopicDescriptor(
              LOCAL_DOMAIN, participant, information.getValue(), TIMEOUT, descriptor),
          "type",
          type.name());
    } finally {
      // Not earlier: the descriptor is created from the type.
      cyclone.dynamicTypeUnref(root);
      if (information.getValue() != null) {
        cyclone.freeTypeinfo(information.getValue());
      }
    }
    TopicDescriptor made = new TopicDescriptor(descriptor.getValue());
    try {
      made.dropTypeInformation(DdsNames.type(type));
      return check(
          cyclone.createTopic(participant, made.pointer(), name, null, null), "topic", name);
    } finally {
      made.restore();
      cyclone.deleteTopicDescriptor(made.pointer());
    }
  }

  private Type structure(MessageType message, boolean nested) {
    Descriptor.ByValue descriptor = new Descriptor.ByValue();
    descriptor.kind = STRUCT;
    descriptor.name = DdsNames.type(message);
    Type type = create(descriptor, message.name());
    check(cyclone.dynamicTypeSetExtensibility(type, FINAL), "type", message.name());
    check(cyclone.dynamicTypeSetNested(type, nested), "type", message.name());
    int id = 0;
    for (MessageType.Field field : message.fields()) {
      Member.ByValue member = member(field.name(), id++);
      set(member.type, field.type());
      check(cyclone.dynamicTypeAddMember(type, member), "field", field.name());
    }
    if (message.fields().isEmpty()) {
      Member.ByValue member = member("structure_needs_at_least_one_member", 0);
      member.type.primitive(primitive(FieldType.Kind.UINT8));
      check(cyclone.dynamicTypeAddMember(type, member), "type", message.name());
    }
    return type;
  }

  private static Member.ByValue member(String name, int id) {
    Member.ByValue member = new Member.ByValue();
    member.name = name;
    member.id = id;
    member.index = AT_END;
    return member;
  }

  private void set(Spec target, FieldType type) {
    if (type.shape() == FieldType.Shape.SINGLE) {
      setSingle(target, type);
      return;
    }
    Descriptor.ByValue descriptor = new Descriptor.ByValue();
    descriptor.kind = type.shape() == FieldType.Shape.ARRAY ? ARRAY : SEQUENCE;
    descriptor.name = "several";
    setSingle(descriptor.element, type);
    bound(descriptor, type.size());
    target.defined(create(descriptor, type.toString()));
  }

  private void setSingle(Spec target, FieldType type) {
    switch (type.kind()) {
      case MESSAGE -> target.defined(structure(type.message().orElseThrow(), true));
      case STRING -> {
        Descriptor.ByValue descriptor = new Descriptor.ByValue();
        descriptor.kind = STRING8;
        bound(descriptor, type.stringBound());
        target.defined(create(descriptor, type.toString()));
      }
      default -> target.primitive(primitive(type.kind()));
    }
  }

  private static void bound(Descriptor descriptor, int size) {
    if (size > 0) {
      Memory bounds = new Memory(Integer.BYTES);
      bounds.setInt(0, size);
      descriptor.boundCount = 1;
      descriptor.bounds = bounds;
    }
  }

  private static int primitive(FieldType.Kind kind) {
    return switch (kind) {
      case BOOL -> 1;
      case INT16 -> 3;
      case INT32 -> 4;
      case INT64 -> 5;
      case UINT16 -> 6;
      case UINT32 -> 7;
      case UINT64 -> 8;
      case FLOAT32 -> 9;
      case FLOAT64 -> 10;
      case INT8 -> 12;
      case BYTE, CHAR, UINT8 -> 13;
      case STRING, MESSAGE -> throw new IllegalArgumentException(kind + " is not a number.");
    };
  }

  private Type create(Descriptor.ByValue descriptor, String what) {
    Type made = cyclone.dynamicTypeCreate(participant, descriptor);
    check(made.result, "type", what);
    // From here on passed by reference.
    Type type = new Type();
    type.first = made.first;
    type.second = made.second;
    type.result = made.result;
    return type;
  }

  private int check(int result, String kind, String name) {
    if (result < 0) {
      throw new IllegalArgumentException(
          "Cyclone DDS refuses the " + kind + " " + name + ": " + Codes.text(cyclone, result));
    }
    return result;
  }
}
