package dev.eventchain.dds;

import dev.eventchain.messages.FieldType;
import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.messages.MessageType;
import dev.eventchain.messages.MessageValue;
import java.math.BigInteger;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;

/** Random messages with a value in each field. */
final class RandomMessages {

  static final MessageCatalog CATALOG = MessageCatalog.of(List.of());

  private static final List<String> TEXTS = List.of("", "a", "größer", "x".repeat(60));

  private final Random random;

  RandomMessages(long seed) {
    random = new Random(seed);
  }

  static MessageType type(String name) {
    return CATALOG.find(name).orElseThrow();
  }

  MessageValue next(MessageType type) {
    MessageValue message = MessageValue.of(type);
    for (MessageType.Field field : type.fields()) {
      message.set(field.name(), value(field.type()));
    }
    return message;
  }

  private Object value(FieldType type) {
    if (type.shape() == FieldType.Shape.SINGLE) {
      return single(type);
    }
    int most = type.size() > 0 ? Math.min(type.size(), 4) : 4;
    int count = type.shape() == FieldType.Shape.ARRAY ? type.size() : random.nextInt(most + 1);
    List<Object> values = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      values.add(single(type));
    }
    return values;
  }

  private Object single(FieldType type) {
    return switch (type.kind()) {
      case MESSAGE -> next(type.message().orElseThrow());
      case STRING -> TEXTS.get(random.nextInt(TEXTS.size()));
      case BOOL -> random.nextBoolean();
      case FLOAT32, FLOAT64 -> random.nextFloat();
      case BYTE, CHAR, UINT8 -> random.nextInt(256);
      case INT8 -> random.nextInt(256) - 128;
      case INT16 -> random.nextInt(1 << 16) - (1 << 15);
      case UINT16 -> random.nextInt(1 << 16);
      case INT32 -> random.nextInt();
      case UINT32 -> random.nextInt() & 0xFFFFFFFFL;
      case INT64 -> random.nextLong();
      case UINT64 -> new BigInteger(64, random);
    };
  }
}
