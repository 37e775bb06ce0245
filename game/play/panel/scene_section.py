"""The panel's section of scenes: which one is played, and the ways to open and save one."""

from game.world.scenes.scene import scene_names


class SceneSection:
    """The list of scenes, and the buttons below it."""

    def __init__(self, sessions, commands):
        self._sessions, self._commands = sessions, commands
        self._names = scene_names()

    def lay_out(self, ui):
        """Show the section and do what it was told."""
        scene, commands = self._sessions.now.scene, self._commands
        names = self._names if scene.name in self._names else (*self._names, scene.name)
        titles = [self._sessions.title_of(name) for name in names]
        now = names.index(scene.name)
        chosen = ui.choice("Scene", titles, now, tip="Replaces this sand and these walls with another scene")
        if chosen != now:
            commands.open_shipped(names[chosen])
        if scene.notice:
            ui.text(scene.notice, dim=True)
        ui.row(3)
        if ui.button("Gallery", key="F2", tip="All scenes at once, running, with a sentence about each"):
            commands.show_scenes()
        if ui.button("Save", key="Ctrl+S", tip="Saves sand, walls and settings in one picture"):
            commands.save()
        if ui.button("Open", key="Ctrl+O", tip="Shows the saved scenes; the one you open replaces this one"):
            commands.open_scenes()
