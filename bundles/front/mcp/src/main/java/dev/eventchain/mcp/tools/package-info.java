/** Tools, resources and prompts, with the schemas of what goes in and comes out. */
package dev.eventchain.mcp.tools;
