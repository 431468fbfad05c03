package dev.eventchain.dds;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import com.sun.jna.Pointer;
import com.sun.jna.ptr.PointerByReference;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Proxy;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** The real library passes; one with other topic descriptors in memory is refused. */
class LayoutCheckTest {

  private static final long FLAGS = 8;
  private static final long INFORMATION_SIZE = 64;
  private static final long MAPPING_SIZE = 80;

  static Stream<Arguments> changes() {
    return Stream.of(
        change("no flag", descriptor -> descriptor.setInt(FLAGS, 0)),
        change("no size", descriptor -> descriptor.setInt(INFORMATION_SIZE, 0)),
        change("a pointer for a size", descriptor -> descriptor.setInt(MAPPING_SIZE, 0x7f00_1000)));
  }

  private static Arguments change(String name, Consumer<Pointer> change) {
    return Arguments.of(name, change);
  }

  @Test
  void theLibraryPasses() {
    LayoutCheck.run(libraryWith(descriptor -> {}));
  }

  @ParameterizedTest(name = "{0}")
  @MethodSource("changes")
  void anotherLayoutIsRefused(String name, Consumer<Pointer> change) {
    DdsLibrary changed = libraryWith(change);
    IllegalStateException problem =
        assertThrows(IllegalStateException.class, () -> LayoutCheck.run(changed));
    assertEquals("The library describes types in an unknown way.", problem.getMessage(), name);
  }

  private static DdsLibrary libraryWith(Consumer<Pointer> change) {
    DdsLibrary library = Wire.library();
    Object changed =
        Proxy.newProxyInstance(
            Cyclone.class.getClassLoader(),
            new Class<?>[] {Cyclone.class},
            (proxy, method, arguments) -> {
              try {
                Object result = method.invoke(library.cyclone(), arguments);
                if (method.getName().equals("createTopicDescriptor")) {
                  change.accept(((PointerByReference) arguments[4]).getValue());
                }
                return result;
              } catch (InvocationTargetException e) {
                throw e.getCause();
              }
            });
    return new DdsLibrary(library.path(), (Cyclone) changed);
  }
}
