package dev.eventchain.workspace;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.sandbox.PythonEnvironment;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests what launch files start, and what is asked of them. */
class LaunchFilesTest {

  private static final PythonEnvironment PYTHON = PythonEnvironment.ensure(said -> {});

  @TempDir Path folder;

  /** ROS 2 has no scope for an included file: only a group restores what was set. */
  @Test
  void whatAnIncludedFileSetsHoldsBehindIt() throws IOException {
    write(
        "part.launch.xml",
        "<launch><arg name='side' default='left'/><push_ros_namespace namespace='$(var side)'/>"
            + "<set_remap from='request' to='/first'/><set_parameter name='a' value='1'/>"
            + "<node pkg='braking' exec='brake' name='part'/></launch>");
    String include = "<include file='$(dirname)/part.launch.xml'>%s</include>";
    check(
        "<node pkg='braking' exec='brake' name='before'/>"
            + ("<group>" + include.formatted("<arg name='side' value='inner'/>") + "</group>")
            + "<node pkg='braking' exec='brake' name='between'/>"
            + include.formatted("<let name='side' value='right'/>")
            + "<node pkg='braking' exec='brake' name='$(var side)'>"
            + "<remap from='request' to='/own'/></node>"
            + "<set_remap from='request' to='/second'/>"
            + include.formatted(""),
        """
        /before {} {}
        /inner/part {a=1} {request=/first}
        /between {} {}
        /right/part {a=1} {request=/first}
        /right/right {a=1} {request=/first}
        /right/right/part {a=1} {request=/first}
        """);
  }

  @Test
  void conditionsOfKnownArgumentsAreDecided() throws IOException {
    check(
        "<arg name='near' default='True'/><arg name='far' default='0'/><arg name='given'/>"
            + "<arg name='near' default='false' unless='$(var near)'/>"
            + "<node pkg='braking' exec='brake' name='if_near' if='$(var near)'/>"
            + "<node pkg='braking' exec='brake' name='unless_near' unless='$(var near)'/>"
            + "<node pkg='braking' exec='brake' name='if_far' if=' $(var far) '/>"
            + "<node pkg='braking' exec='brake' name='unless_far' unless='$(var far)'/>"
            + "<group if='$(var far)'><node pkg='braking' exec='brake' name='in_far'/></group>"
            + "<let name='side' value='left' if='$(var far)'/>"
            + "<let name='open' value='left'/><let name='open' value='right' if='$(var given)'/>"
            + "<node pkg='braking' exec='brake' name='$(var side none)'/>"
            + "<node pkg='braking' exec='brake' name='x_$(var open)'/>"
            + "<node pkg='braking' exec='brake' name='odd' if='yes'/>"
            + "<node pkg='braking' exec='brake' name='both' if='true' unless='false'/>",
        """
        /if_near {} {}
        /unless_far {} {}
        /none {} {}
        /Brake {} {}
        /odd {} {}
        /both {} {}
        Is this launched? It is under a condition, and taken as launched.
        What is the name of this node?
        Is this launched? It is under a condition, and taken as launched.
        Is this launched? It is under a condition, and taken as launched.
        """);
  }

  /** A parameter that is perhaps set has no known value; one that is set has. */
  @Test
  void parametersUnderConditionsAreDecided() throws IOException {
    write("some.yaml", "/**: {ros__parameters: {d: 1, e: 1}}");
    String file = "<set_parameters_from_file filename='$(dirname)/some.yaml' %s/>";
    check(
        "<arg name='on' default='true'/><arg name='given'/>"
            + "<set_parameter name='a' value='1' if='$(var on)'/>"
            + "<set_parameter name='b' value='1' unless='$(var on)'/>"
            + file.formatted("if='$(var on)'")
            + "<node pkg='braking' exec='brake' name='one'/>"
            + "<set_parameter name='a' value='2' if='$(var given)'/>"
            + file.formatted("unless='$(var given)'")
            + "<set_parameter name='e' value='2'/>"
            + "<node pkg='braking' exec='brake' name='two'/>",
        """
        /one {a=1, d=1, e=1} {}
        /two {e=2} {}
        Is this launched? It is under a condition, and taken as launched.
        Is this launched? It is under a condition, and taken as launched.
        """);
  }

  /** What a condition excludes by default is no launch file of its own. */
  @Test
  void filesUnderConditionsAreIncluded() throws IOException {
    write("part.launch.xml", "<launch><node pkg='braking' exec='brake' name='part'/></launch>");
    check(
        "<arg name='more' default='false'/><node pkg='braking' exec='brake' name='one'/>"
            + "<include file='$(dirname)/part.launch.xml' if='$(var more)'/>",
        "/one {} {}\n");
  }

  /** A name of a variable may be that of another one, in part. */
  @Test
  void namesOfVariablesMayHaveVariables() throws IOException {
    check(
        "<let name='side' value='left'/><let name='left_name' value='a'/>"
            + "<node pkg='braking' exec='brake' name='$(var $(var side)_name)'/>"
            + "<node pkg='braking' exec='brake' name='$(var  $(var side)_no  b)'/>"
            + "<node pkg='braking' exec='brake' name='$(var $(env SIDE)_name c)'/>",
        """
        /a {} {}
        /b {} {}
        /Brake {} {}
        What is the name of this node?
        """);
  }

  /** The file that is included may depend on conditions, and a file may include itself. */
  @Test
  void alternativesAreIncluded() throws IOException {
    for (String name : new String[] {"left", "right"}) {
      write(
          name + ".launch.xml",
          "<launch><node pkg='braking' exec='brake' name='" + name + "'/></launch>");
    }
    check(
        "<arg name='on' default='true'/>"
            + "<let name='part' value='left' if='$(var on)'/>"
            + "<let name='part' value='right' unless='$(var on)'/>"
            + "<include file='$(dirname)/$(var part).launch.xml'/>"
            + "<include file='$(dirname)/all.launch.xml' unless='$(var on)'/>",
        "/left {} {}\n");
  }

  /** Values that double, and a file that includes itself twice. */
  @Test
  void whatMultipliesIsAskedFor() throws IOException {
    StringBuilder lets = new StringBuilder("<let name='a0' value='aa'/>");
    for (int i = 0; i < 60; i++) {
      lets.append("<let name='a%s' value='$(var a%s)$(var a%s)'/>".formatted(i + 1, i, i));
    }
    String again = "<include file='$(dirname)/all.launch.xml'/>";
    write("all.launch.xml", "<launch>" + lets + again.repeat(2) + "</launch>");
    FoundSoftware found = Workspace.read(folder, Optional.empty(), PYTHON);
    assertTrue(
        found.questions().stream()
            .anyMatch(it -> it.text().startsWith("Which nodes does the incl")));
  }

  @Test
  void conditionsInPythonAreDecided() throws IOException {
    checkPython(
        """
            side = LaunchConfiguration("side")
            return LaunchDescription([
                DeclareLaunchArgument("side", default_value="left"),
                DeclareLaunchArgument("on", default_value="true"),
                brake("a", condition=IfCondition(LaunchConfiguration("on"))),
                brake("b", condition=UnlessCondition(LaunchConfiguration("on"))),
                brake("c", condition=IfCondition(EqualsSubstitution(side, "left"))),
                brake("d", condition=UnlessCondition(EqualsSubstitution(side, "left"))),
                brake("e", condition=IfCondition(NotEqualsSubstitution(side, "right"))),
                brake("f", condition=LaunchConfigurationEquals("side", "right")),
                brake("g", condition=LaunchConfigurationNotEquals("side", "right")),
                brake("h", condition=LaunchConfigurationEquals("on", "True")),
                brake("i", condition=IfCondition(PythonExpression(["'", side, "' == 'left'"]))),
            ])
        """
            .replace("brake(", "Node(package='braking', executable='brake', name="),
        """
        /a {} {}
        /c {} {}
        /e {} {}
        /g {} {}
        /h {} {}
        /i {} {}
        Is this launched? It is under a condition, and taken as launched.
        """);
  }

  @Test
  void expressionsAreEvaluatedAsFarAsTheyAreOfLiterals() throws IOException {
    checkPython(
        """
            side = LaunchConfiguration("side")
            on = LaunchConfiguration("on")
            return LaunchDescription([
                DeclareLaunchArgument("side", default_value="left"),
                DeclareLaunchArgument("on", default_value="true"),
                DeclareLaunchArgument("number", default_value="3"),
                brake("no", condition=IfCondition(PythonExpression(["'", side, "' == 'right'"]))),
                brake("in", condition=IfCondition(PythonExpression(["'", side, "' in ['left', 'right']"]))),
                brake("unless", condition=UnlessCondition(PythonExpression(["not '", side, "'.startswith('l')"]))),
                brake("both", condition=IfCondition(AndSubstitution(on, NotSubstitution("false")))),
                brake("either", condition=UnlessCondition(OrSubstitution(on, "false"))),
                brake(["x", PythonExpression([LaunchConfiguration("number"), " * 2 + 1"])]),
                brake(IfElseSubstitution(on, if_value="chosen", else_value="other")),
                brake("named", condition=IfCondition(PythonExpression([on, " == True"]))),
                brake("called", condition=IfCondition(PythonExpression(["__import__('os').getpid() > 0"]))),
            ])
        """
            .replace("brake(", "Node(package='braking', executable='brake', name="),
        """
        /in {} {}
        /unless {} {}
        /both {} {}
        /x7 {} {}
        /chosen {} {}
        /named {} {}
        /called {} {}
        Is this launched? It is under a condition, and taken as launched.
        Is this launched? It is under a condition, and taken as launched.
        """);
  }

  @Test
  void substitutionsInXmlAndYamlDecideAsThoseInPython() throws IOException {
    write(
        "part.launch.yaml",
        """
        launch:
        - node: {pkg: braking, exec: brake, name: yaml, if: "$(and $(var on) $(not false))"}
        - node: {pkg: braking, exec: brake, name: none, if: "$(equals $(var side) right)"}
        """);
    check(
        "<arg name='side' default='left'/><arg name='on' default='True'/>"
            + "<node pkg='braking' exec='brake' name='one' if=\"$(eval '\\'$(var side)\\' == \\'left\\'')\"/>"
            + "<node pkg='braking' exec='brake' name='two' if=\"$(eval &quot;'$(var side)' != 'left'&quot;)\"/>"
            + "<node pkg='braking' exec='brake' name='three' unless='$(not-equals $(var side) left)'/>"
            + "<node pkg='braking' exec='brake' name='$(if $(var on) four five)'/>"
            + "<node pkg='braking' exec='brake' name='six' if='$(any false $(var on))'/>"
            + "<node pkg='braking' exec='brake' name='odd' if='$(and $(var on))'/>"
            + "<include file='$(dirname)/part.launch.yaml'/>",
        """
        /one {} {}
        /three {} {}
        /four {} {}
        /six {} {}
        /odd {} {}
        /yaml {} {}
        Is this launched? It is under a condition, and taken as launched.
        """);
  }

  /** What follows on the start of a node that starts is launched; other events may never come. */
  @Test
  void eventHandlersLaunchWhatFollows() throws IOException {
    checkPython(
        """
            first = brake("first")
            never = brake("never", condition=IfCondition("false"))
            return LaunchDescription([
                RegisterEventHandler(OnProcessStart(target_action=first, on_start=[LogInfo(msg="up"), brake("second")])),
                first,
                never,
                RegisterEventHandler(event_handler=OnProcessStart(target_action=never, on_start=brake("third"))),
                RegisterEventHandler(OnProcessExit(target_action=first, on_exit=[brake("fourth")])),
                RegisterEventHandler(OnProcessExit(target_action=first, on_exit=[EmitEvent(event=Shutdown())])),
                RegisterEventHandler(OnShutdown(on_shutdown=[LogInfo(msg="down")])),
                GroupAction([
                    PushRosNamespace("left"),
                    RegisterEventHandler(OnProcessStart(target_action=first, on_start=[brake("fifth")])),
                ]),
                RegisterEventHandler(OnProcessIO(target_action=first, on_stdout=look)),
            ])
        """
            .replace("brake(", "Node(package='braking', executable='brake', name="),
        """
        /second {} {}
        /first {} {}
        /third {} {}
        /fourth {} {}
        /left/fifth {} {}
        Which nodes does this launch: what 'RegisterEventHandler' launches is not read?
        Is this launched? It waits for an event of another process, and is taken as launched.
        Is this launched? It waits for an event of another process, and is taken as launched.
        Which arguments, namespace, remappings and parameters do the nodes of this event handler \
        get? Those where it stands are taken; ROS 2 may take those that are left when the event \
        comes.
        """);
  }

  @Test
  void nodesInContainersAreRead() throws IOException {
    write("none.txt", "");
    source(
        "CMakeLists.txt",
        """
        add_library(parts SHARED src/relay.cpp)
        rclcpp_components_register_node(parts PLUGIN "parts::Relay" EXECUTABLE relay)
        """);
    source(
        "src/relay.cpp",
        """
        class Relay : public rclcpp::Node {
          explicit Relay(const rclcpp::NodeOptions & options) : Node("relay", options) {
            in_ = create_subscription<std_msgs::msg::Bool>("in", 10, callback);
            out_ = create_publisher<std_msgs::msg::Bool>("out", 10);
          }
        };
        RCLCPP_COMPONENTS_REGISTER_NODE(parts::Relay)
        """);
    write(
        "part.launch.xml",
        "<launch><group><push_ros_namespace namespace='xml'/>"
            + "<node_container pkg='rclcpp_components' exec='component_container' name='box'"
            + " namespace='not_theirs'><composable_node pkg='braking' plugin='parts::Relay' name='a'>"
            + "<remap from='in' to='/x'/></composable_node></node_container>"
            + "<load_composable_node target='/box'><composable_node pkg='braking'"
            + " plugin='parts::Other' name='b'/></load_composable_node></group>"
            + "<node pkg='braking' exec='relay' name='alone'/></launch>");
    write(
        "all.launch.py",
        """
        def generate_launch_description():
            nodes = [ComposableNode(package="braking", plugin="parts::Relay", name="c", namespace="py")]
            return LaunchDescription([
                IncludeLaunchDescription([FindPackageShare("braking"), "/launch/part.launch.xml"]),
                ComposableNodeContainer(name="box", namespace="", package="rclcpp_components",
                    executable="component_container_mt", composable_node_descriptions=nodes),
                LoadComposableNodes(target_container="box", composable_node_descriptions=[
                    ComposableNode(package="elsewhere", plugin="elsewhere::Thing")]),
            ])
        """);
    FoundSoftware found = Workspace.read(folder, Optional.empty(), PYTHON);
    assertEquals(
        "[/xml/a [/x, /xml/out], /alone [/in, /out], /py/c [/py/in, /py/out]]",
        found.nodes().stream()
            .map(
                node ->
                    node.name()
                        + " "
                        + node.endpoints().stream().map(FoundEndpoint::topic).toList())
            .toList()
            .toString());
    assertEquals(
        List.of(
            "What does the node 'parts::Other' of braking read and write? Its source was not understood.",
            "What does the node 'elsewhere::Thing' read and write? The package elsewhere is not in the workspace."),
        found.questions().stream()
            .map(OpenQuestion::text)
            .filter(it -> it.contains("::"))
            .toList());
  }

  private void source(String name, String text) throws IOException {
    Path file = folder.resolve("src/braking").resolve(name);
    Files.createDirectories(file.getParent());
    Files.writeString(file, text);
  }

  /** Lists are often filled by one statement after the other. */
  @Test
  void whatIsAddedToListsIsLaunched() throws IOException {
    checkPython(
        """
            declared = []
            declared.append(DeclareLaunchArgument("side", default_value="left"))
            words = ["--ros-args", "--log-level", "debug"]
            names = [("request", "/a")]
            names.append(("other", "/b"))
            nodes = [Node(package="braking", executable="brake", name="one")]
            nodes.append(Node(package="braking", executable="brake", name=LaunchConfiguration("side")))
            nodes.extend([
                Node(package="braking", executable="brake", name="two", remappings=names, arguments=words),
            ])
            nodes.extend(nodes)
            nodes.insert(0, Node(package="braking", executable="brake", name="three"))
            nodes.append(Node(package="braking", name="four", **{"executable": "brake"}))
            return LaunchDescription(initial_entities=declared + nodes)
        """,
        """
        /one {} {}
        /left {} {}
        /two {} {}
        Which name is remapped to which?
        Which nodes does this launch: 'nodes' is a part of itself?
        Which nodes does this launch: 'nodes.insert' changes it when it runs?
        Which nodes does this launch: what '**' gives 'Node' is not read?
        """);
  }

  /** Two defaults of one configuration are those of two substitutions. */
  @Test
  void functionsThatReturnListsAreRead() throws IOException {
    checkPython(
        """
            first = LaunchConfiguration("none", default="first")
            second = LaunchConfiguration("none", default=LaunchConfiguration("side"))
            return LaunchDescription([
                DeclareLaunchArgument("side", default_value="left"),
                Node(package="braking", executable="brake", name=first),
                Node(package="braking", executable="brake", name=second),
                OpaqueFunction(function=setup),
                OpaqueFunction(function=decides),
                OpaqueFunction(function=setup, args=["right"]),
                Node(package="braking", executable="brake", name=LaunchConfiguration("none")),
            ])


        def setup(context, *args, **kwargs):
            \"""Starts a node.\"""
            side = LaunchConfiguration("side").perform(context)
            return [
                SetLaunchConfiguration("none", "set"),
                Node(package="braking", executable="brake", name=f"{side}_brake", namespace=side),
            ]


        def decides(context):
            if context.launch_configurations["side"] == "left":
                return [Node(package="braking", executable="brake", name="decided")]
        """,
        """
        /first {} {}
        /left {} {}
        /left/left_brake {} {}
        /set {} {}
        Which nodes does this launch: 'decides' decides it when it runs?
        Which nodes does this launch: what 'OpaqueFunction' launches is not read?
        """);
  }

  /** Older versions of launch restore nothing when a timer fires. */
  @Test
  void timersAreAskedForWhereVersionsDiffer() throws IOException {
    String node = "<node pkg='braking' exec='brake' name='%s'/>";
    String timer = "<timer period='2'>" + node + "</timer>";
    check(
        "<set_parameter name='a' value='1'/>"
            + timer.formatted("same")
            + ("<group><push_ros_namespace namespace='left'/>" + timer.formatted("in_group"))
            + "<node pkg='braking' exec='brake' name='beside'/></group>"
            + "<timer period='1'><push_ros_namespace namespace='right'/></timer>"
            + node.formatted("last"),
        """
        /same {a=1} {}
        /left/in_group {a=1} {}
        /left/beside {a=1} {}
        /last {a=1} {}
        Which arguments, namespace, remappings and parameters do the nodes of this timer get? \
        Those where it stands are taken, as newer versions of ROS 2 do; older ones take those that \
        are left when it fires.
        """);
  }

  /** Launch restores which list of remappings there is, and not what is in it. */
  @Test
  void whatAGroupAddsToAListIsAskedFor() throws IOException {
    check(
        "<group><set_remap from='request' to='/alone'/></group>"
            + "<node pkg='braking' exec='brake' name='one'/>"
            + "<set_parameter name='a' value='1'/><set_remap from='unused' to='/x'/>"
            + "<group><set_remap from='request' to='/inner'/></group>"
            + "<node pkg='braking' exec='brake' name='two'/>"
            + "<group><set_parameter name='a' value='2'/>"
            + "<node pkg='braking' exec='brake' name='three'/></group>",
        """
        /one {} {}
        /two {a=1} {unused=/x}
        /three {a=2} {unused=/x}
        Does what this group sets for all of its nodes end with it? It is taken to; but ROS 2 adds \
        remappings and parameters to what is set around the group.
        """);
  }

  @Test
  void groupsInYamlAndPythonMayHaveConfigurations() throws IOException {
    write(
        "part.launch.yaml",
        """
        launch:
        - group:
            scoped: true
            keep: [{name: side, value: yaml}]
            children:
            - node: {pkg: braking, exec: brake, name: $(var side)}
        """);
    checkPython(
        """
            part = [FindPackageShare("braking"), "/launch/part.launch.yaml"]
            kept = {"side": "python"}
            side = LaunchConfiguration("side", default="none")
            return LaunchDescription([
                IncludeLaunchDescription(AnyLaunchDescriptionSource(part)),
                GroupAction(
                    [PushROSNamespace("space"), Node(package="braking", executable="brake", name=side)],
                    launch_configurations=kept,
                ),
                SetLaunchConfiguration("side", "set"),
                UnsetLaunchConfiguration("side"),
                Node(package="braking", executable="brake", name=side),
            ])
        """,
        """
        /yaml {} {}
        /space/python {} {}
        /none {} {}
        """);
  }

  private void checkPython(String body, String expected) throws IOException {
    write("all.launch.py", "def generate_launch_description():\n" + body);
    check(expected);
  }

  private void check(String elements, String expected) throws IOException {
    write("all.launch.xml", "<launch>" + elements + "</launch>");
    check(expected);
  }

  private void check(String expected) {
    FoundSoftware found = Workspace.read(folder, Optional.empty(), PYTHON);
    StringBuilder said = new StringBuilder();
    for (FoundNode node : found.nodes()) {
      PythonNode python = node.python().orElseThrow();
      said.append("%s %s %s%n".formatted(node.name(), python.parameters(), python.remappings()));
    }
    found.questions().stream()
        .filter(each -> each.file().contains("/launch/"))
        .filter(each -> !each.text().startsWith("Are these nodes a part"))
        .forEach(each -> said.append(each.text()).append('\n'));
    assertEquals(expected, said.toString());
  }

  private void write(String name, String text) throws IOException {
    Path launch = folder.resolve("src/braking/launch");
    if (!Files.exists(launch)) {
      copyWithoutLaunchFiles();
      Files.createDirectories(launch);
    }
    Files.writeString(launch.resolve(name), text);
  }

  private void copyWithoutLaunchFiles() throws IOException {
    Path from = Path.of("src/test/resources/ws");
    try (var files = Files.walk(from)) {
      for (Path file : files.filter(Files::isRegularFile).toList()) {
        Path to = folder.resolve(from.relativize(file).toString());
        if (!file.getParent().endsWith("launch")) {
          Files.createDirectories(to.getParent());
          Files.copy(file, to);
        }
      }
    }
  }
}
