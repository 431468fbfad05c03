package dev.eventchain.maven;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.StringReader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.codehaus.plexus.util.xml.Xpp3Dom;
import org.codehaus.plexus.util.xml.Xpp3DomBuilder;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests that the documented pom snippets use only goals and parameters of the plugin. */
class WrittenPomsTest {

  private static final Pattern PLUGIN = Pattern.compile("(?s)<plugin>.*?</plugin>");

  @ParameterizedTest
  @ValueSource(strings = {"README.md", "../../documentation/src/site/build-server.md"})
  void goalsAndParametersExist(String page) throws Exception {
    Set<String> known = new TreeSet<>();
    for (Xpp3Dom goal : descriptor().getChild("mojos").getChildren()) {
      known.add("goal " + goal.getChild("goal").getValue());
      for (Xpp3Dom parameter : goal.getChild("parameters").getChildren()) {
        known.add(parameter.getChild("name").getValue());
      }
    }
    List<String> used = new ArrayList<>();
    Matcher plugin = PLUGIN.matcher(Files.readString(Path.of(page)));
    while (plugin.find()) {
      Xpp3Dom written = Xpp3DomBuilder.build(new StringReader(plugin.group()));
      for (Xpp3Dom parameter : written.getChild("configuration").getChildren()) {
        used.add(parameter.getName());
      }
      for (Xpp3Dom execution : written.getChild("executions").getChildren()) {
        used.add("goal " + execution.getChild("goals").getChild("goal").getValue());
      }
    }
    assertTrue(used.size() >= 4, used::toString);
    used.removeAll(known);
    assertEquals(List.of(), used);
  }

  private static Xpp3Dom descriptor() throws Exception {
    return Xpp3DomBuilder.build(
        Files.newBufferedReader(Path.of("target/classes/META-INF/maven/plugin.xml")));
  }
}
