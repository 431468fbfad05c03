package dev.eventchain.project;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;

import dev.eventchain.description.EventChainReader;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.model.eventchain.EventChain;
import java.nio.file.Path;
import java.util.List;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;

/** Units within existing components, of which a designed chain says nothing. */
class UnaskedUnitsTest {

  private static final Path FOLDER =
      Path.of("src/test/resources/cases/base/component-in-other-units");

  @Test
  void theSoftwareBaseStatesThem() {
    String designed =
        SourceText.read(FOLDER.resolve("components.json"))
            .text()
            .replaceAll(",\\s*\"component_unit\": \"[^\"]*\"", "");
    EventChain chain =
        EventChainReader.read(
                SourceText.of("chain.json", designed), "c", List.of(), OptionalDouble.empty())
            .root();
    SoftwareBase base = SoftwareBase.read(FOLDER);
    List<Diagnostic> before = base.check(chain, (element, feature) -> SourceLocation.NONE);
    assertEquals(
        List.of("modeler.component.value.changed"),
        before.stream().map(Diagnostic::id).distinct().toList());
    base.addUnasked(chain, chain);
    assertEquals(List.of(), base.check(chain, (element, feature) -> SourceLocation.NONE));
    assertEquals("percent", chain.getData().get(0).getComponentUnit());
    assertNull(chain.getData().get(1).getComponentUnit());
  }
}
