/** Commands of the command line, each in a process of its own. */
package dev.eventchain.mcp.program;
