package dev.eventchain.pipeline.results;

import com.fasterxml.jackson.core.JsonGenerator;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.databind.BeanProperty;
import com.fasterxml.jackson.databind.DeserializationContext;
import com.fasterxml.jackson.databind.JavaType;
import com.fasterxml.jackson.databind.JsonDeserializer;
import com.fasterxml.jackson.databind.JsonMappingException;
import com.fasterxml.jackson.databind.JsonSerializer;
import com.fasterxml.jackson.databind.SerializerProvider;
import com.fasterxml.jackson.databind.deser.ContextualDeserializer;
import com.fasterxml.jackson.databind.module.SimpleModule;
import java.io.IOException;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalLong;
import java.util.Set;
import java.util.function.Function;

/** Optional values in JSON: a missing key is an empty value, and null is an error. */
final class OptionalValues {

  static final Set<Class<?>> TYPES =
      Set.of(Optional.class, OptionalDouble.class, OptionalLong.class);

  private OptionalValues() {}

  /** Returns readers and writers of all types. */
  static SimpleModule module() {
    SimpleModule module = new SimpleModule();
    add(module, Optional.class, Optional.empty(), Object.class, Optional::of, value -> value);
    add(
        module,
        OptionalDouble.class,
        OptionalDouble.empty(),
        Double.class,
        OptionalDouble::of,
        value -> value.stream().boxed().findFirst());
    add(
        module,
        OptionalLong.class,
        OptionalLong.empty(),
        Long.class,
        OptionalLong::of,
        value -> value.stream().boxed().findFirst());
    return module;
  }

  private static <T, C> void add(
      SimpleModule module,
      Class<T> type,
      T empty,
      Class<C> content,
      Function<C, T> of,
      Function<T, Optional<?>> contentOf) {
    module.addSerializer(type, new Writer<>(type, contentOf));
    module.addDeserializer(
        type, new Reader<>(empty, content, value -> of.apply(content.cast(value))));
  }

  private static final class Writer<T> extends JsonSerializer<T> {

    private final Class<T> type;
    private final Function<T, Optional<?>> content;

    Writer(Class<T> type, Function<T, Optional<?>> content) {
      this.type = type;
      this.content = content;
    }

    @Override
    public Class<T> handledType() {
      return type;
    }

    @Override
    public boolean isEmpty(SerializerProvider provider, T value) {
      return content.apply(value).isEmpty();
    }

    @Override
    public void serialize(T value, JsonGenerator json, SerializerProvider provider)
        throws IOException {
      provider.defaultSerializeValue(content.apply(value).orElse(null), json);
    }
  }

  private static final class Reader<T> extends JsonDeserializer<T>
      implements ContextualDeserializer {

    private final T empty;
    private final Class<?> content;
    private final Function<Object, T> of;
    private final JavaType type;

    Reader(T empty, Class<?> content, Function<Object, T> of) {
      this(empty, content, of, null);
    }

    private Reader(T empty, Class<?> content, Function<Object, T> of, JavaType type) {
      this.empty = empty;
      this.content = content;
      this.of = of;
      this.type = type;
    }

    @Override
    public JsonDeserializer<T> createContextual(
        DeserializationContext context, BeanProperty property) {
      JavaType declared = context.getContextualType();
      JavaType inner =
          declared != null && declared.hasRawClass(Optional.class)
              ? declared.containedTypeOrUnknown(0)
              : context.constructType(content);
      return new Reader<>(empty, content, of, inner);
    }

    @Override
    public T deserialize(JsonParser parser, DeserializationContext context) throws IOException {
      return of.apply(context.readValue(parser, type));
    }

    @Override
    public T getNullValue(DeserializationContext context) throws JsonMappingException {
      return context.reportInputMismatch(this, "null instead of a missing key");
    }

    @Override
    public Object getAbsentValue(DeserializationContext context) {
      return empty;
    }
  }
}
